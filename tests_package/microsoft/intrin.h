// What Microsoft's <intrin.h> declares of what src uses, with vectors as they are there: unions without
// operators, elements or conversions. For microsoft.sh, which looks at syntax only.
#pragma once

#include <stddef.h>
#include <stdint.h>

#define VECTOR(name, size, member)           \
    union __declspec(align(size)) name {     \
        member bytes[size / sizeof(member)]; \
    }
VECTOR(__m128, 16, float);
VECTOR(__m128d, 16, double);
VECTOR(__m128i, 16, int64_t);
VECTOR(__m256, 32, float);
VECTOR(__m256d, 32, double);
VECTOR(__m256i, 32, int64_t);
VECTOR(__m512, 64, float);
VECTOR(__m512d, 64, double);
VECTOR(__m512i, 64, int64_t);
#undef VECTOR
typedef unsigned char __mmask8;

#define _MM_SHUFFLE(d, c, b, a) (((d) << 6) | ((c) << 4) | ((b) << 2) | (a))
#define _MM_HINT_T0 1
#define _CMP_LT_OS 1
#define _CMP_LE_OS 2
#define _CMP_EQ_OS 16
#define _CMP_EQ_OQ 0
#define _CMP_LT_OQ 17
#define _CMP_LE_OQ 18
#define _CMP_NLT_UQ 21

// clang has builtins of these names, with the long of Windows.
#define _BitScanForward scan_forward
#define _BitScanReverse scan_reverse
#define _xgetbv get_extended_control

extern "C" {
unsigned char _BitScanForward(unsigned long*, unsigned long);
unsigned char _BitScanReverse(unsigned long*, unsigned long);
void __cpuidex(int[4], int, int);
unsigned long long _xgetbv(unsigned int);
void _mm_pause(void);
void _mm_prefetch(const char*, int);

#define BINARY(type, prefix, suffix)                                                                               \
    type prefix##_add_##suffix(type, type), prefix##_sub_##suffix(type, type), prefix##_mul_##suffix(type, type),  \
        prefix##_div_##suffix(type, type), prefix##_min_##suffix(type, type), prefix##_max_##suffix(type, type),   \
        prefix##_and_##suffix(type, type), prefix##_andnot_##suffix(type, type), prefix##_or_##suffix(type, type), \
        prefix##_xor_##suffix(type, type), prefix##_unpacklo_##suffix(type, type),                                 \
        prefix##_unpackhi_##suffix(type, type), prefix##_sqrt_##suffix(type)
BINARY(__m128, _mm, ps);
BINARY(__m128d, _mm, pd);
BINARY(__m256, _mm256, ps);
BINARY(__m256d, _mm256, pd);
BINARY(__m512d, _mm512, pd);
#undef BINARY

__m128 _mm_set1_ps(float), _mm_setr_ps(float, float, float, float), _mm_loadu_ps(const float*);
__m128 _mm_set_ss(float), _mm_setzero_ps(void), _mm_move_ss(__m128, __m128), _mm_permute_ps(__m128, int);
__m128 _mm_movelh_ps(__m128, __m128), _mm_movehl_ps(__m128, __m128), _mm_shuffle_ps(__m128, __m128, unsigned);
__m128 _mm_cmplt_ps(__m128, __m128), _mm_cmple_ps(__m128, __m128), _mm_cmpneq_ps(__m128, __m128);
__m128 _mm_castsi128_ps(__m128i), _mm_cvtpd_ps(__m128d), _mm_cvtepi32_ps(__m128i);
void _mm_storeu_ps(float*, __m128), _mm_store_ps(float*, __m128);
int _mm_movemask_ps(__m128);

__m128d _mm_set1_pd(double), _mm_setr_pd(double, double), _mm_loadu_pd(const double*);
__m128d _mm_cmplt_pd(__m128d, __m128d), _mm_cmple_pd(__m128d, __m128d);
__m128d _mm_castsi128_pd(__m128i), _mm_cvtps_pd(__m128);
void _mm_storeu_pd(double*, __m128d), _mm_store_sd(double*, __m128d);
int _mm_movemask_pd(__m128d);
double _mm_cvtsd_f64(__m128d);
__m128 _mm_insert_ps(__m128, __m128, int);

__m128i _mm_set1_epi32(int), _mm_setr_epi32(int, int, int, int), _mm_cvtsi32_si128(int);
int _mm_cvtsi128_si32(__m128i);
__m128i _mm_castps_si128(__m128), _mm_cvttps_epi32(__m128), _mm_cvtepi8_epi32(__m128i);
__m128i _mm_add_epi32(__m128i, __m128i), _mm_min_epu32(__m128i, __m128i), _mm_min_epi32(__m128i, __m128i), _mm_max_epi32(__m128i, __m128i);
__m128i _mm_cmpeq_epi32(__m128i, __m128i), _mm_cmpgt_epi32(__m128i, __m128i), _mm_srai_epi32(__m128i, int);
int _mm_movemask_epi8(__m128i);
unsigned _mm_getcsr();
void _mm_setcsr(unsigned);
__m128i _mm_and_si128(__m128i, __m128i), _mm_or_si128(__m128i, __m128i);
__m128i _mm_unpacklo_epi32(__m128i, __m128i), _mm_unpackhi_epi32(__m128i, __m128i);
__m128i _mm_shuffle_epi32(__m128i, int), _mm_blend_epi32(__m128i, __m128i, int), _mm_loadl_epi64(const __m128i*);
void _mm_storeu_si128(__m128i*, __m128i);

__m256 _mm256_set1_ps(float), _mm256_setzero_ps(void), _mm256_set_m128(__m128, __m128);
__m256 _mm256_setr_ps(float, float, float, float, float, float, float, float);
__m256 _mm256_loadu_ps(const float*), _mm256_load_ps(const float*), _mm256_castsi256_ps(__m256i);
__m256 _mm256_permute2f128_ps(__m256, __m256, int), _mm256_permute_ps(__m256, int);
__m256 _mm256_blend_ps(__m256, __m256, int), _mm256_blendv_ps(__m256, __m256, __m256);
__m256 _mm256_shuffle_ps(__m256, __m256, int), _mm256_cmp_ps(__m256, __m256, int);
__m256 _mm256_castps128_ps256(__m128), _mm256_insertf128_ps(__m256, __m128, int);
__m256 _mm256_permutevar8x32_ps(__m256, __m256i), _mm256_mask_blend_ps(__mmask8, __m256, __m256);
__m128 _mm256_castps256_ps128(__m256), _mm256_extractf128_ps(__m256, int), _mm256_cvtpd_ps(__m256d);
void _mm256_storeu_ps(float*, __m256);
float _mm256_cvtss_f32(__m256);
int _mm256_movemask_ps(__m256);
__mmask8 _mm256_cmp_ps_mask(__m256, __m256, int), _mm256_movepi32_mask(__m256i);

__m256d _mm256_set1_pd(double), _mm256_setr_pd(double, double, double, double), _mm256_loadu_pd(const double*);
__m256d _mm256_maskload_pd(const double*, __m256i), _mm256_castsi256_pd(__m256i), _mm256_cvtps_pd(__m128);
__m256d _mm256_permute2f128_pd(__m256d, __m256d, int), _mm256_blendv_pd(__m256d, __m256d, __m256d);
__m256d _mm256_cmp_pd(__m256d, __m256d, int), _mm256_blend_pd(__m256d, __m256d, int), _mm256_setzero_pd(void);
__m128d _mm256_castpd256_pd128(__m256d), _mm256_extractf128_pd(__m256d, int);
__m256d _mm256_permute_pd(__m256d, int), _mm256_permute4x64_pd(__m256d, int);
double _mm256_cvtsd_f64(__m256d);
void _mm256_storeu_pd(double*, __m256d), _mm256_store_pd(double*, __m256d);
int _mm256_movemask_pd(__m256d);

__m256i _mm256_set1_epi32(int), _mm256_set1_epi64x(long long), _mm256_setzero_si256(void);
__m256i _mm256_setr_epi32(int, int, int, int, int, int, int, int);
__m256i _mm256_setr_epi64x(long long, long long, long long, long long);
__m256i _mm256_loadu_si256(const __m256i*), _mm256_load_si256(const __m256i*), _mm256_castps_si256(__m256);
__m256i _mm256_castsi128_si256(__m128i), _mm256_cvttps_epi32(__m256), _mm256_cvtepi8_epi32(__m128i);
__m256i _mm256_and_si256(__m256i, __m256i), _mm256_or_si256(__m256i, __m256i), _mm256_srai_epi32(__m256i, int);
__m256i _mm256_cmpeq_epi32(__m256i, __m256i), _mm256_cmpgt_epi64(__m256i, __m256i);
__m256i _mm256_min_epi32(__m256i, __m256i), _mm256_max_epi32(__m256i, __m256i);
__m256i _mm256_unpacklo_epi32(__m256i, __m256i), _mm256_unpackhi_epi32(__m256i, __m256i);
__m256i _mm256_permutevar8x32_epi32(__m256i, __m256i), _mm256_permute2x128_si256(__m256i, __m256i, int);
__m256i _mm256_blendv_epi8(__m256i, __m256i, __m256i), _mm256_mask_blend_epi32(__mmask8, __m256i, __m256i);
__m256i _mm256_mask_mov_epi32(__m256i, __mmask8, __m256i);
__m128i _mm256_castsi256_si128(__m256i), _mm256_extracti128_si256(__m256i, int);
void _mm256_storeu_si256(__m256i*, __m256i);
__mmask8 _mm256_cmpeq_epi32_mask(__m256i, __m256i);

__m512d _mm512_set1_pd(double), _mm512_loadu_pd(const void*), _mm512_cvtps_pd(__m256);
__m512d _mm512_setr_pd(double, double, double, double, double, double, double, double);
__m512d _mm512_mask_blend_pd(__mmask8, __m512d, __m512d), _mm512_permutex2var_pd(__m512d, __m512i, __m512d);
__m512d _mm512_castpd256_pd512(__m256d), _mm512_insertf64x4(__m512d, __m256d, int);
__m256d _mm512_castpd512_pd256(__m512d), _mm512_extractf64x4_pd(__m512d, int);
__m256 _mm512_cvtpd_ps(__m512d);
void _mm512_storeu_pd(void*, __m512d), _mm512_storeu_si512(void*, __m512i);
__m512i _mm512_set1_epi64(long long), _mm512_loadu_si512(const void*);
__m512i _mm512_setr_epi64(long long, long long, long long, long long, long long, long long, long long, long long);
__m512i _mm512_maskz_compress_epi64(__mmask8, __m512i);
__mmask8 _mm512_cmp_pd_mask(__m512d, __m512d, int), _mm512_mask_cmple_epi64_mask(__mmask8, __m512i, __m512i);
__mmask8 _kand_mask8(__mmask8, __mmask8), _kor_mask8(__mmask8, __mmask8), _knot_mask8(__mmask8);
}
