#!/usr/bin/env bash
# The NuGet package: an assembly of .NET Standard 2.1 with the library inside. Where the .NET SDK is, it makes and tests
# the package; else the package is made with Mono's compiler and tested on Mono.
source "$(dirname "$0")/common.sh"
native_library

cp -r "$SOURCE/bindings/csharp" stage
mkdir stage/native
cp "$native/lib/libgamephys.so.1" stage/native/libgamephys.so
cp "$SOURCE/LICENSE" stage
rm -f "$PACKAGES"/Gamephys.*.nupkg
if command -v dotnet >/dev/null; then
    dotnet pack stage/Gamephys.csproj --configuration Release --output "$PACKAGES" -p:Version="$version"
    mkdir client
    cd client
    dotnet new console --output . >/dev/null
    cp "$SOURCE/bindings/csharp/examples/pick.cs" Program.cs
    dotnet add package Gamephys --version "$version" --source "$PACKAGES"
    dotnet run
    exit
fi

mkdir -p made
mcs -unsafe -langversion:latest -optimize+ -warnaserror -target:library -out:made/Gamephys.dll stage/src/*.cs
cp "$SOURCE/bindings/csharp/Gamephys.dll.config" "$native/lib/libgamephys.so.1" made
sed "s/@version@/$version/" "$SOURCE/packaging/Gamephys.Mono.nuspec" >made/Gamephys.Mono.nuspec
cp stage/LICENSE stage/README.md made
rm -f "$PACKAGES"/Gamephys.Mono.*.nupkg
nuget pack made/Gamephys.Mono.nuspec -BasePath made -OutputDirectory "$PACKAGES" -NoPackageAnalysis -NonInteractive
empty nuget install Gamephys.Mono -Source "$PACKAGES" -OutputDirectory "$WORK/installed" -NonInteractive
folder=$(echo installed/Gamephys.Mono.*/lib/net48)
for example in scene step pick; do
    mcs -langversion:latest -r:"$folder/Gamephys.dll" -out:$example.exe "$SOURCE/bindings/csharp/examples/$example.cs"
    empty MONO_PATH="$WORK/$folder" mono $example.exe
done
in_part "the package for .NET needs the SDK, which is not installed: made and tested for Mono"
