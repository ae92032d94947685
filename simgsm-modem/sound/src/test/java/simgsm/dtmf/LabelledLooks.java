package simgsm.dtmf;

import java.util.Arrays;

/** Looks at two tones with what they really were: the material to which {@link LikelihoodFit} fits the curves. */
final class LabelledLooks {
    /** A key is looked at so often before the collecting receiver takes it, so that later looks are fitted, too. */
    private static final int LOOKS_PER_KEY = 40;
    /** Q.24 rejects tones of 23 ms; before that a look is neither right nor wrong. */
    private static final int EARLIEST_SAMPLES = 184;

    private float[] values = new float[KeyMeasures.COUNT * 1024];
    private boolean[] isKey = new boolean[1024];
    /** Looks at one key, or at the same tones of other sound without a longer break, are one event. */
    private int[] event = new int[1024];

    private double[] weight = new double[1024];
    private int count;
    private int events;
    /** Key, number on the tape and hop of the look before. */
    private int lastKey;

    private int lastKnown;
    private long lastHop;
    private double tapeWeight;

    int count() {
        return count;
    }

    float value(int look, int kind) {
        return values[look * KeyMeasures.COUNT + kind];
    }

    boolean isKey(int look) {
        return isKey[look];
    }

    int event(int look) {
        return event[look];
    }

    double weight(int look) {
        return weight[look];
    }

    private void begin(double weightOfEvents) {
        lastKey = -1;
        tapeWeight = weightOfEvents;
    }

    /** @param known number of the key on the tape, or -1 */
    private void add(KeyMeasures measures, int key, int known, long hop) {
        if (key != lastKey || known != lastKnown || hop - lastHop > ToneFit.LISTENED) {
            events++;
        }
        lastKey = key;
        lastKnown = known;
        lastHop = hop;
        if (count == isKey.length) {
            isKey = Arrays.copyOf(isKey, 2 * count);
            event = Arrays.copyOf(event, 2 * count);
            weight = Arrays.copyOf(weight, 2 * count);
            values = Arrays.copyOf(values, 2 * values.length);
        }
        for (int kind = 0; kind < KeyMeasures.COUNT; kind++) {
            values[count * KeyMeasures.COUNT + kind] = (float) measures.values[kind];
        }
        event[count] = events;
        weight[count] = tapeWeight;
        isKey[count++] = known >= 0;
    }

    /** Collects from a recording that holds no keys. */
    void collect(short[] samples, double weightOfEvents) {
        begin(weightOfEvents);
        new DtmfReceiver(digit -> {}, null, DtmfReceiver.LIMIT, (hop, key, fit, measures, line, end) -> {
                    measure(fit, measures, line, end);
                    add(measures, key, -1, hop);
                    return Double.NEGATIVE_INFINITY;
                })
                .accept(samples);
    }

    /** Collects from a recording whose keys are known. */
    void collect(Tape tape, double weightOfEvents) {
        begin(weightOfEvents);
        int[] looks = new int[tape.starts.size()];
        new DtmfReceiver(digit -> {}, null, DtmfReceiver.LIMIT, (hop, key, fit, measures, line, end) -> {
                    long now = GoertzelBank.HOP * (hop + 1);
                    int known = known(tape, key, now);
                    if (known < 0) {
                        if (!tape.slipped) {
                            measure(fit, measures, line, end);
                            add(measures, key, -1, hop);
                        }
                        return Double.NEGATIVE_INFINITY;
                    }
                    if (now < tape.starts.get(known) + EARLIEST_SAMPLES || now > tape.ends.get(known) + 20) {
                        return Double.NEGATIVE_INFINITY;
                    }
                    measure(fit, measures, line, end);
                    add(measures, key, known, hop);
                    return ++looks[known] == LOOKS_PER_KEY || now > tape.ends.get(known) - 60
                            ? Double.POSITIVE_INFINITY
                            : Double.NEGATIVE_INFINITY;
                })
                .accept(tape.samples());
    }

    private static void measure(ToneFit fit, KeyMeasures measures, short[] line, int end) {
        measures.measureTones(fit);
        measures.measureSpectrum(fit, line, end);
    }

    /** The digit of the tape that sounds, or has just ended, at that sample, or -1. */
    private static int known(Tape tape, int key, long now) {
        for (int i = 0; i < tape.starts.size(); i++) {
            if (DtmfKey.of(tape.expected.charAt(i)).ordinal() == key
                    && now >= tape.starts.get(i) + 150
                    && now <= tape.ends.get(i) + 300) {
                return i;
            }
        }
        return -1;
    }
}
