package simgsm.dtmf;

/**
 * Hears keys in 8 kHz, 16-bit mono speech, streaming: any chunk size, no allocation but the digits themselves. Owned by
 * one thread.
 */
public final class DtmfReceiver {
    private static final int HOP = 40;
    private static final int WINDOW = 160;
    private static final double FLOOR_DBM0 = -46;

    private final DtmfListener listener;
    private final short[] window = new short[WINDOW];
    private final Goertzel[] rows = new Goertzel[4];
    private final Goertzel[] columns = new Goertzel[4];
    private long heard;
    private int fill;
    private DtmfKey candidate;
    private int hits;
    private int misses;
    private DtmfDigit current;

    public DtmfReceiver(DtmfListener listener) {
        this.listener = listener;
        for (int i = 0; i < 4; i++) {
            rows[i] = new Goertzel(DtmfKey.ROW_HERTZ[i]);
            columns[i] = new Goertzel(DtmfKey.COLUMN_HERTZ[i]);
        }
    }

    public void accept(short[] samples) {
        accept(samples, 0, samples.length);
    }

    /** The next {@code samples[from..to)} of the stream. */
    public void accept(short[] samples, int from, int to) {
        for (int i = from; i < to; i++) {
            shift(samples[i]);
        }
    }

    /** The stream ends here: a key that still sounds ends, too. */
    public void finish() {
        end();
    }

    /** As new: a new call begins. */
    public void reset() {
        heard = 0;
        fill = 0;
        candidate = null;
        current = null;
        hits = 0;
        misses = 0;
        java.util.Arrays.fill(window, (short) 0);
    }

    private void shift(short sample) {
        window[WINDOW - HOP + fill] = sample;
        heard++;
        if (++fill == HOP) {
            fill = 0;
            judge();
            System.arraycopy(window, HOP, window, 0, WINDOW - HOP);
        }
    }

    private void judge() {
        DtmfKey key = keyInWindow();
        hits = key != null && key == candidate ? hits + 1 : key == null ? 0 : 1;
        candidate = key;
        if (current != null && key == current.key()) {
            misses = 0;
        } else if (current != null && ++misses == 4) {
            end();
        }
        if (current == null && hits == 3) {
            decide();
        }
    }

    private void decide() {
        misses = 0;
        int row = candidate.row();
        int column = candidate.column();
        current = new DtmfDigit(
                candidate,
                heard,
                heard - WINDOW - HOP,
                WINDOW + HOP,
                ToneLevel.dbm0(rows[row].amplitude()),
                ToneLevel.dbm0(columns[column].amplitude()),
                0,
                0);
        listener.keyDecided(current);
    }

    private void end() {
        if (current == null) {
            return;
        }
        DtmfDigit ended = current;
        current = null;
        listener.keyEnded(new DtmfDigit(
                ended.key(),
                ended.decidedAtSample(),
                ended.startedAtSample(),
                Math.max(0, heard - misses * HOP - ended.startedAtSample()),
                ended.rowDbm0(),
                ended.columnDbm0(),
                ended.rowError(),
                ended.columnError()));
    }

    private DtmfKey keyInWindow() {
        double total = 0;
        for (short sample : window) {
            total += (double) sample * sample;
        }
        int row = strongest(rows);
        int column = strongest(columns);
        double low = rows[row].amplitude();
        double high = columns[column].amplitude();
        boolean loud = ToneLevel.dbm0(low) > FLOOR_DBM0 && ToneLevel.dbm0(high) > FLOOR_DBM0;
        boolean balanced = high < 4 * low && low < 4 * high;
        boolean pure = (low * low + high * high) * WINDOW / 2 > 0.6 * total;
        return loud && balanced && pure ? DtmfKey.at(row, column) : null;
    }

    private int strongest(Goertzel[] group) {
        int best = 0;
        for (int i = 0; i < 4; i++) {
            group[i].reset();
            group[i].accept(window, 0, WINDOW);
            if (group[i].energy() > group[best].energy()) {
                best = i;
            }
        }
        return best;
    }
}
