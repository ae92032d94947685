/* SpanDSP's DTMF sender and receiver on raw files: 8 kHz, 16 bit, native byte order, mono.
 *   spandsp_dtmf rx FILE        prints the keys that dtmf_rx hears
 *   spandsp_dtmf tx KEYS FILE   writes the keys as dtmf_tx sends them
 */
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <spandsp.h>

#define BLOCK 160

static int receive(const char *path)
{
    int16_t block[BLOCK];
    char keys[MAX_DTMF_DIGITS + 1];
    size_t samples;
    FILE *file = fopen(path, "rb");
    dtmf_rx_state_t *rx = dtmf_rx_init(NULL, NULL, NULL);

    if (file == NULL || rx == NULL)
        return 1;
    while ((samples = fread(block, sizeof(block[0]), BLOCK, file)) > 0)
        dtmf_rx(rx, block, (int) samples);
    dtmf_rx_get(rx, keys, MAX_DTMF_DIGITS);
    puts(keys);
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

int main(int argc, char *argv[])
{
    if (argc == 3 && strcmp(argv[1], "rx") == 0)
        return receive(argv[2]);
    if (argc == 4 && strcmp(argv[1], "tx") == 0)
        return send(argv[2], argv[3]);
    fputs("usage: spandsp_dtmf rx FILE | tx KEYS FILE\n", stderr);
    return 2;
}
