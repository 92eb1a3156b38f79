/* Mesh files by assimp's C interface. */
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "viewer.h"

static void* allocate(size_t count, size_t size) {
    void* memory = calloc(count ? count : 1, size);
    if (!memory) {
        fprintf(stderr, "out of memory\n");
        exit(1);
    }
    return memory;
}

/* Height 1, lowest point on y = 0, middle above the origin. */
static void stand_upright(triangle_mesh* mesh) {
    gphys_vec3 low = mesh->vertices[0], high = low;
    for (uint32_t i = 1; i < mesh->vertex_count; ++i) {
        const gphys_vec3 v = mesh->vertices[i];
        low.x = fminf(low.x, v.x), low.y = fminf(low.y, v.y), low.z = fminf(low.z, v.z);
        high.x = fmaxf(high.x, v.x), high.y = fmaxf(high.y, v.y), high.z = fmaxf(high.z, v.z);
    }
    const float height = high.y > low.y ? high.y - low.y : 1;
    for (uint32_t i = 0; i < mesh->vertex_count; ++i) {
        gphys_vec3* v = &mesh->vertices[i];
        v->x = (v->x - (low.x + high.x) / 2) / height;
        v->y = (v->y - low.y) / height;
        v->z = (v->z - (low.z + high.z) / 2) / height;
    }
}

int load_mesh(const char* path, triangle_mesh* out) {
    const unsigned steps = aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_PreTransformVertices |
                           aiProcess_SortByPType | aiProcess_DropNormals;
    const struct aiScene* file = aiImportFile(path, steps);
    if (!file) {
        fprintf(stderr, "%s: %s\n", path, aiGetErrorString());
        return -1;
    }
    uint32_t vertex_count = 0, index_count = 0;
    for (unsigned m = 0; m < file->mNumMeshes; ++m) {
        vertex_count += file->mMeshes[m]->mNumVertices;
        index_count += file->mMeshes[m]->mNumFaces * 3;
    }
    out->vertices = allocate(vertex_count, sizeof *out->vertices);
    out->normals = allocate(vertex_count, sizeof *out->normals);
    out->indices = allocate(index_count, sizeof *out->indices);
    out->vertex_count = out->index_count = 0;
    for (unsigned m = 0; m < file->mNumMeshes; ++m) {
        const struct aiMesh* part = file->mMeshes[m];
        for (unsigned f = 0; f < part->mNumFaces; ++f) {
            if (part->mFaces[f].mNumIndices != 3) continue; /* points and lines */
            for (int k = 0; k < 3; ++k) {
                out->indices[out->index_count++] = out->vertex_count + part->mFaces[f].mIndices[k];
            }
        }
        for (unsigned v = 0; v < part->mNumVertices; ++v) {
            const struct aiVector3D p = part->mVertices[v];
            out->vertices[out->vertex_count++] = (gphys_vec3){p.x, p.y, p.z};
        }
    }
    aiReleaseImport(file);
    if (out->index_count == 0) {
        fprintf(stderr, "%s: no triangles\n", path);
        free_mesh(out);
        return -1;
    }
    stand_upright(out);
    compute_normals(out);
    return 0;
}

void compute_normals(triangle_mesh* mesh) {
    for (uint32_t i = 0; i < mesh->vertex_count; ++i) mesh->normals[i] = (gphys_vec3){0, 0, 0};
    for (uint32_t i = 0; i < mesh->index_count; i += 3) {
        const gphys_vec3 a = mesh->vertices[mesh->indices[i]], b = mesh->vertices[mesh->indices[i + 1]],
                         c = mesh->vertices[mesh->indices[i + 2]];
        const gphys_vec3 u = {b.x - a.x, b.y - a.y, b.z - a.z}, v = {c.x - a.x, c.y - a.y, c.z - a.z};
        const gphys_vec3 n = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
        for (int k = 0; k < 3; ++k) {
            gphys_vec3* sum = &mesh->normals[mesh->indices[i + k]];
            sum->x += n.x, sum->y += n.y, sum->z += n.z;
        }
    }
    for (uint32_t i = 0; i < mesh->vertex_count; ++i) {
        gphys_vec3* n = &mesh->normals[i];
        const float length = sqrtf(n->x * n->x + n->y * n->y + n->z * n->z);
        if (length > 0) n->x /= length, n->y /= length, n->z /= length;
    }
}

void free_mesh(triangle_mesh* mesh) {
    free(mesh->vertices);
    free(mesh->normals);
    free(mesh->indices);
    *mesh = (triangle_mesh){0};
}
