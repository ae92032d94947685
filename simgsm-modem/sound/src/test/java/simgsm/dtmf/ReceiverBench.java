package simgsm.dtmf;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BiConsumer;

/**
 * The receiver's figures in one table: required, refused and harder kinds of the {@link Catalogue}, disturbed keys, a
 * tape of telephone lines, breaks and echoes, vowels, voices as they are and treated, and delay. Arguments: seed,
 * recordings per kind, files of voices without keys (raw, 8 kHz, 16 bit). {@code -Dverbose=true} prints rows.
 */
final class ReceiverBench {
    private static final boolean VERBOSE = Boolean.getBoolean("verbose");

    private static final class Count {
        int keys;
        int missed;
        int extra;

        void add(String expected, String heard) {
            int common = DisturbedBench.common(expected, heard);
            keys += expected.length();
            missed += expected.length() - common;
            extra += heard.length() - common;
        }
    }

    private final Map<String, Count> rows = new TreeMap<>();
    private final List<Double> delays = new ArrayList<>();

    private void tape(String group, String kind, Tape tape) {
        List<DtmfDigit> heard = Bench.hear(tape.samples());
        String text = Bench.text(heard);
        rows.computeIfAbsent(group, name -> new Count()).add(tape.expected.toString(), text);
        if (VERBOSE) {
            rows.computeIfAbsent(group + ": " + kind, name -> new Count()).add(tape.expected.toString(), text);
        }
        for (int i = 0; text.contentEquals(tape.expected) && i < heard.size() && !tape.slipped; i++) {
            if (group.startsWith("1")) {
                delays.add((heard.get(i).decidedAtSample() - tape.starts.get(i)) / 8.0);
            }
        }
    }

    private void silent(String group, String kind, short[] sound) {
        List<DtmfDigit> heard = Bench.hear(sound);
        rows.computeIfAbsent(group, name -> new Count()).add("", Bench.text(heard));
        for (DtmfDigit digit : heard) {
            System.out.printf(
                    "false %s at %.3f s of %s, %s%n", digit.key(), digit.startedAtSample() / 8000.0, kind, group);
        }
    }

    private void broken(long seed) {
        for (int gap : new int[] {0, 2, 5, 10, 15, 19}) {
            for (int drop : new int[] {6, 10, 12, 14, 20}) {
                tape("5 gaps and drops", gap + " ms " + drop + " dB", BrokenTapes.broken(seed, 70, gap, 100, drop));
            }
        }
        for (int delay : new int[] {20, 60, 90, 100, 105, 110, 115, 120}) {
            for (int drop : new int[] {12, 16, 20}) {
                tape("5 short echoes", delay + " ms " + drop + " dB", BrokenTapes.echo(seed, 150, delay, drop));
            }
        }
        for (int delay : new int[] {220, 250, 300, 350}) {
            for (int drop : new int[] {16, 20, 25}) {
                tape("5 late echoes", delay + " ms " + drop + " dB", BrokenTapes.echo(seed, 100, delay, drop));
            }
        }
        for (int millis : new int[] {30, 60, 100}) {
            for (int drop : new int[] {6, 12, 20}) {
                tape("5 limited beginnings", millis + " ms " + drop, BrokenTapes.limited(seed, millis, drop));
            }
        }
        for (int pause : new int[] {25, 30, 40}) {
            for (int drop : new int[] {0, 12}) {
                tape("5 the same key again", pause + " ms " + drop, BrokenTapes.twice(seed, pause, drop));
            }
        }
    }

    private void run(long seed, int count, String[] files) throws Exception {
        for (Catalogue.Kind kind : Catalogue.kinds()) {
            String group = switch (kind.grade()) {
                case REQUIRED -> "1 required";
                case HARDER -> "3 harder";
                default -> "2 refused";
            };
            Catalogue.tapes(kind, count, seed).forEach(tape -> tape(group, kind.name(), tape));
        }
        BiConsumer<String, Tape> disturbed = (name, tape) -> tape("4 disturbed", name, tape);
        DisturbedTapes.all(seed, count, disturbed);
        DisturbedTapes.others(seed, count, (name, tape) -> tape("4 others", name, tape));
        broken(seed);
        for (int hertz = 85; hertz <= 260; hertz++) {
            silent("6 vowels", hertz + " Hz", VoiceTapes.vowels(hertz, seed));
        }
        double hours = 0;
        List<short[]> voices = new ArrayList<>();
        for (String file : files) {
            short[] speech = LikelihoodFit.read(file);
            voices.add(speech);
            hours += speech.length / 28.8e6;
            VoiceTapes.treated(speech)
                    .forEach((name, sound) -> silent(
                            name.equals("as it is") ? "7 voices" : "7 voices, treated", file + " " + name, sound));
        }
        short[] speech = voices.isEmpty() ? new short[0] : voices.get(0);
        if (speech.length > 0) {
            LineTapes.all(seed, LineTapes.RECORDINGS, speech, (name, tape) -> tape("8 lines", name, tape));
        }
        rows.forEach((name, row) ->
                System.out.printf("%-50s %6d keys %5d missed %4d extra%n", name, row.keys, row.missed, row.extra));
        double[] sorted = delays.stream().mapToDouble(d -> d).sorted().toArray();
        System.out.printf(
                "delay %.1f, median %.1f, 95 %% %.1f ms; %.2f h of voices%n",
                sorted[0], sorted[sorted.length / 2], sorted[sorted.length * 95 / 100], hours);
    }

    public static void main(String[] args) throws Exception {
        String[] files = java.util.Arrays.copyOfRange(args, 2, args.length);
        new ReceiverBench().run(Long.parseLong(args[0]), Integer.parseInt(args[1]), files);
    }
}
