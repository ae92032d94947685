package simgsm.tone;

import static simgsm.tone.ToneCadence.burst;
import static simgsm.tone.ToneCadence.pause;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/** The call-progress tones of one part of the world. */
public enum ToneSet {
    /**
     * TS 22.001, annex F, its European column: 425 Hz for all but special information. ITU-T E.180 recommends -10
     * dBm0 within 5 dB at a point of 0 dBr; these are in its lower half, softer than keys.
     */
    EUROPEAN {
        private static final double LEVEL = -13;

        @Override
        void fill(Map<ProgressTone, ToneCadence> tones) {
            put(tones, ProgressTone.DIAL, burst(1000, LEVEL, 425.0));
            put(tones, ProgressTone.RING_BACK, burst(1000, LEVEL, 425.0), pause(4000));
            put(tones, ProgressTone.BUSY, burst(500, LEVEL, 425.0), pause(500));
            put(tones, ProgressTone.CONGESTION, burst(200, LEVEL, 425.0), pause(200));
            put(tones, ProgressTone.CALL_DROPPED, burst(200, LEVEL, 425.0), pause(200));
            put(
                    tones,
                    ProgressTone.CALL_WAITING,
                    burst(200, LEVEL, 425.0),
                    pause(600),
                    burst(200, LEVEL, 425.0),
                    pause(3000));
            put(
                    tones,
                    ProgressTone.SPECIAL_INFORMATION,
                    burst(330, LEVEL, 950.0),
                    burst(330, LEVEL, 1400.0),
                    burst(330, LEVEL, 1800.0),
                    pause(1000));
        }
    },

    /**
     * North America's Precise Tone Plan with its levels, each of one frequency; special information as "vacant code",
     * with its own three frequencies and lengths.
     */
    AMERICAN {
        @Override
        void fill(Map<ProgressTone, ToneCadence> tones) {
            put(tones, ProgressTone.DIAL, burst(1000, -13, 350.0, 440.0));
            put(tones, ProgressTone.RING_BACK, burst(2000, -19, 440.0, 480.0), pause(4000));
            put(tones, ProgressTone.BUSY, burst(500, -24, 480.0, 620.0), pause(500));
            put(tones, ProgressTone.CONGESTION, burst(250, -24, 480.0, 620.0), pause(250));
            put(tones, ProgressTone.CALL_DROPPED, burst(250, -24, 480.0, 620.0), pause(250));
            put(tones, ProgressTone.CALL_WAITING, burst(300, -13, 440.0), pause(9700));
            put(
                    tones,
                    ProgressTone.SPECIAL_INFORMATION,
                    burst(380, -24, 985.2),
                    burst(274, -24, 1370.6),
                    burst(380, -24, 1776.7),
                    pause(1000));
        }
    };

    private final Map<ProgressTone, ToneCadence> cadences = new EnumMap<>(ProgressTone.class);

    ToneSet() {
        fill(cadences);
    }

    abstract void fill(Map<ProgressTone, ToneCadence> tones);

    private static void put(Map<ProgressTone, ToneCadence> tones, ProgressTone tone, ToneCadence.Step... steps) {
        tones.put(tone, new ToneCadence(List.of(steps)));
    }

    public ToneCadence cadence(ProgressTone tone) {
        return cadences.get(tone);
    }

    /** @param word {@code eu} or {@code us}, as in command lines */
    public static ToneSet of(String word) {
        return switch (word) {
            case "eu" -> EUROPEAN;
            case "us" -> AMERICAN;
            default -> throw new IllegalArgumentException("expected eu or us, found " + word);
        };
    }
}
