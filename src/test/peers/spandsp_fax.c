/* SpanDSP's T.4 sender and receiver on a fax file: each page is read by t4_tx as a fax machine sends it, its bits are
 * decoded by t4_rx, and a line is printed for each page: width, length, resolutions in dots a metre, bad rows.
 *   spandsp_fax FILE
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <tiffio.h>
#include <spandsp.h>

int main(int argc, char *argv[])
{
    t4_tx_state_t *tx;
    t4_rx_state_t *rx;
    t4_stats_t stats;
    char copy[1024];

    if (argc != 2)
    {
        fputs("usage: spandsp_fax FILE\n", stderr);
        return 2;
    }
    snprintf(copy, sizeof(copy), "%s.received", argv[1]);
    tx = t4_tx_init(NULL, argv[1], -1, -1);
    rx = t4_rx_init(NULL, copy, T4_COMPRESSION_ITU_T4_1D);
    if (tx == NULL || rx == NULL)
    {
        fputs("the file is not taken\n", stderr);
        return 1;
    }
    t4_rx_set_rx_encoding(rx, T4_COMPRESSION_ITU_T4_1D);
    t4_tx_set_tx_encoding(tx, T4_COMPRESSION_ITU_T4_1D);
    t4_rx_set_image_width(rx, t4_tx_get_image_width(tx));
    t4_rx_set_x_resolution(rx, t4_tx_get_x_resolution(tx));
    t4_rx_set_y_resolution(rx, t4_tx_get_y_resolution(tx));
    while (t4_tx_start_page(tx) == 0)
    {
        int bit;

        t4_rx_start_page(rx);
        do
        {
            bit = t4_tx_get_bit(tx);
            if (bit == SIG_STATUS_END_OF_DATA)
                break;
        }
        while (!t4_rx_put_bit(rx, bit));
        t4_rx_get_transfer_statistics(rx, &stats);
        printf("%d %d %d %d %d\n", stats.width, stats.length, stats.x_resolution, stats.y_resolution, stats.bad_rows);
        t4_rx_end_page(rx);
        t4_tx_end_page(tx);
    }
    t4_rx_release(rx);
    t4_tx_release(tx);
    return 0;
}
