/* SpanDSP's DTMF sender and receiver, and its G.726 codec, on raw files: 8 kHz, 16 bit, native byte order, mono.
 *   spandsp_dtmf rx FILE...           prints the keys that dtmf_rx hears, a line per file
 *   spandsp_dtmf rx-wide FILE...      the same with dial-tone notches and a twist of 10 and 6 dB
 *   spandsp_dtmf tx KEYS FILE         writes the keys as dtmf_tx sends them
 *   spandsp_dtmf g726 RATE FILE OUT   writes the sound behind G.726 at RATE bit/s
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <spandsp.h>

#define BLOCK 160

static void heard(void *user, const char *digits, int len)
{
    (void) user;
    fwrite(digits, 1, (size_t) len, stdout);
}

static int receive(const char *path, int wide)
{
    int16_t block[BLOCK];
    size_t samples;
    FILE *file = fopen(path, "rb");
    dtmf_rx_state_t *rx = dtmf_rx_init(NULL, heard, NULL);

    if (file == NULL || rx == NULL)
        return 1;
    if (wide)
        dtmf_rx_parms(rx, 1, 10, 6, -99);
    while ((samples = fread(block, sizeof(block[0]), BLOCK, file)) > 0)
        dtmf_rx(rx, block, (int) samples);
    putchar('\n');
    dtmf_rx_free(rx);
    fclose(file);
    return 0;
}

static int send(const char *keys, const char *path)
{
    int16_t block[BLOCK];
    int samples;
    FILE *file = fopen(path, "wb");
    dtmf_tx_state_t *tx = dtmf_tx_init(NULL);

    if (file == NULL || tx == NULL || dtmf_tx_put(tx, keys, (int) strlen(keys)) != 0)
        return 1;
    while ((samples = dtmf_tx(tx, block, BLOCK)) > 0)
        fwrite(block, sizeof(block[0]), (size_t) samples, file);
    memset(block, 0, sizeof(block));
    fwrite(block, sizeof(block[0]), BLOCK, file);
    fclose(file);
    return 0;
}

static int recode(int rate, const char *path, const char *to)
{
    int16_t block[BLOCK];
    uint8_t coded[BLOCK];
    size_t samples;
    FILE *file = fopen(path, "rb");
    FILE *out = fopen(to, "wb");
    g726_state_t *encoder = g726_init(NULL, rate, G726_ENCODING_LINEAR, G726_PACKING_NONE);
    g726_state_t *decoder = g726_init(NULL, rate, G726_ENCODING_LINEAR, G726_PACKING_NONE);

    if (file == NULL || out == NULL || encoder == NULL || decoder == NULL)
        return 1;
    while ((samples = fread(block, sizeof(block[0]), BLOCK, file)) > 0)
    {
        int octets = g726_encode(encoder, coded, block, (int) samples);
        int n = g726_decode(decoder, block, coded, octets);
        fwrite(block, sizeof(block[0]), (size_t) n, out);
    }
    fclose(out);
    fclose(file);
    return 0;
}

int main(int argc, char *argv[])
{
    int i;

    if (argc >= 3 && strncmp(argv[1], "rx", 2) == 0)
    {
        for (i = 2; i < argc; i++)
        {
            if (receive(argv[i], strcmp(argv[1], "rx-wide") == 0) != 0)
                return 1;
        }
        return 0;
    }
    if (argc == 4 && strcmp(argv[1], "tx") == 0)
        return send(argv[2], argv[3]);
    if (argc == 5 && strcmp(argv[1], "g726") == 0)
        return recode(atoi(argv[2]), argv[3], argv[4]);
    fputs("usage: spandsp_dtmf rx|rx-wide FILE... | tx KEYS FILE | g726 RATE FILE OUT\n", stderr);
    return 2;
}
