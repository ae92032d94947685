package simgsm.dtmf;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;

/**
 * Tries the receiver with {@link DisturbedTapes} and with files of speech and music (raw, 8 kHz, 16 bit), and prints a row
 * per kind: keys, how many were not heard, how many were heard too often or wrongly. Arguments: recordings per kind, seed,
 * files.
 */
final class DisturbedBench {
    private static final class Count {
        int keys;
        int missed;
        int extra;

        void add(String expected, String heard) {
            int common = common(expected, heard);
            keys += expected.length();
            missed += expected.length() - common;
            extra += heard.length() - common;
        }
    }

    /** Length of the longest common subsequence. */
    static int common(String a, String b) {
        int[][] length = new int[a.length() + 1][b.length() + 1];
        for (int i = 1; i <= a.length(); i++) {
            for (int j = 1; j <= b.length(); j++) {
                length[i][j] = a.charAt(i - 1) == b.charAt(j - 1)
                        ? length[i - 1][j - 1] + 1
                        : Math.max(length[i - 1][j], length[i][j - 1]);
            }
        }
        return length[a.length()][b.length()];
    }

    public static void main(String[] args) throws Exception {
        int count = Integer.parseInt(args[0]);
        long seed = Long.parseLong(args[1]);
        Map<String, Count> counts = new LinkedHashMap<>();
        BiConsumer<String, Tape> tried = (name, tape) -> counts.computeIfAbsent(name, kind -> new Count())
                .add(tape.expected.toString(), Bench.text(Bench.hear(tape.samples())));
        DisturbedTapes.all(seed, count, tried);
        DisturbedTapes.others(seed, count, tried);
        double hours = 0;
        int falseKeys = 0;
        for (int i = 2; i < args.length; i++) {
            short[] speech = LikelihoodFit.read(args[i]);
            DisturbedTapes.over(seed, count / 4, speech, tried);
            List<DtmfDigit> heard = Bench.hear(speech);
            hours += speech.length / 28.8e6;
            falseKeys += heard.size();
            for (DtmfDigit digit : heard) {
                System.out.printf("false %s at %.3f s of %s%n", digit.key(), digit.decidedAtSample() / 8000.0, args[i]);
            }
        }
        counts.forEach((name, row) ->
                System.out.printf("%-45s %6d keys %5d missed %4d extra%n", name, row.keys, row.missed, row.extra));
        System.out.printf("%d false keys in %.1f h without keys%n", falseKeys, hours);
    }
}
