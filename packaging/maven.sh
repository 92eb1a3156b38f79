#!/usr/bin/env bash
# The Maven artefact, as a repository of files: classes with the library inside, sources, and the pom with JNA as its
# dependency.
source "$(dirname "$0")/common.sh"
native_library

jna=$(echo /usr/share/java/jna.jar)
repository=$PACKAGES/maven/gamephys/gamephys/$version
artefact=$repository/gamephys-$version
rm -rf "$PACKAGES/maven"
mkdir -p classes/linux-x86-64 "$repository"
javac -Xlint:all -Werror --release 17 -cp "$jna" -d classes "$SOURCE"/bindings/java/src/main/java/gamephys/*.java
cp "$native/lib/libgamephys.so.1" classes/linux-x86-64 # where JNA looks, by processor
mkdir classes/META-INF
cp "$SOURCE/LICENSE" classes/META-INF
jar --create --file "$artefact.jar" -C classes .
jar --create --file "$artefact-sources.jar" -C "$SOURCE/bindings/java/src/main/java" .
sed "s/@version@/$version/" "$SOURCE/packaging/pom.xml.in" >"$artefact.pom"
for file in "$artefact"*; do (cd "$repository" && sha1sum "${file##*/}" | cut -d' ' -f1 >"$file.sha1"); done

# With the class path that a build tool makes of the pom: the artefact and JNA.
mkdir client
cp "$SOURCE"/bindings/java/examples/{Scenes,Step,Pick}.java client
javac -cp "$artefact.jar" -d client client/*.java
for example in Scenes Step Pick; do empty java -cp "$artefact.jar:$jna:client" $example; done
python3 - "$artefact.pom" <<'END'
import sys
from xml.etree import ElementTree
names = {"m": "http://maven.apache.org/POM/4.0.0"}
project = ElementTree.parse(sys.argv[1]).getroot()
assert project.find("m:artifactId", names).text == "gamephys"
assert [d.text for d in project.findall(".//m:dependency/m:artifactId", names)] == ["jna"]
END
