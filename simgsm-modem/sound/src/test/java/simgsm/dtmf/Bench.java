package simgsm.dtmf;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simgsm.speech.WavWriter;

/** Tries a receiver with the catalogue's recordings and prints how it did, a row per kind. */
final class Bench {
    record Row(Catalogue.Kind kind, int tapes, int exact, int digits, int falseDigits, double seconds) {}

    private final List<Double> delays = new ArrayList<>();
    private final StringBuilder failures = new StringBuilder();

    Row run(Catalogue.Kind kind, int count, long seed) {
        int exact = 0;
        int digits = 0;
        int falseDigits = 0;
        double seconds = 0;
        for (Tape tape : Catalogue.tapes(kind, count, seed)) {
            List<DtmfDigit> heard = hear(tape.samples());
            seconds += tape.length() / 8000.0;
            digits += tape.expected.length();
            String text = text(heard);
            if (text.contentEquals(tape.expected)) {
                exact++;
                for (int i = 0; i < heard.size() && !tape.slipped; i++) {
                    double delay = (heard.get(i).decidedAtSample() - tape.starts.get(i)) / 8.0;
                    delays.add(delay);
                    if (delay < 23) {
                        failures.append(String.format("  %-36s decided after %.1f ms%n", kind.name(), delay));
                    }
                }
            } else {
                failures.append(String.format(
                        "  %-36s expected %s%n  %36s heard    %s%n", kind.name(), tape.expected, "", text));
                falseDigits += kind.grade() == Catalogue.Grade.SILENT ? heard.size() : 0;
            }
        }
        return new Row(kind, count, exact, digits, falseDigits, seconds);
    }

    static List<DtmfDigit> hear(short[] samples) {
        List<DtmfDigit> heard = new ArrayList<>();
        DtmfReceiver receiver = new DtmfReceiver(heard::add);
        receiver.accept(samples);
        receiver.finish();
        return heard;
    }

    static String text(List<DtmfDigit> digits) {
        StringBuilder text = new StringBuilder();
        digits.forEach(digit -> text.append(digit.key().symbol()));
        return text.toString();
    }

    double delay(double share) {
        double[] sorted = delays.stream().mapToDouble(d -> d).sorted().toArray();
        return sorted.length == 0 ? 0 : sorted[(int) Math.min(sorted.length - 1, share * sorted.length)];
    }

    String failures() {
        return failures.toString();
    }

    static String line(Row row) {
        return String.format(
                "%-9s %-38s %4d of %4d exact %s",
                row.kind.grade().toString().toLowerCase(java.util.Locale.ROOT),
                row.kind.name(),
                row.exact,
                row.tapes,
                row.falseDigits > 0 ? row.falseDigits + " false in " + Math.round(row.seconds) + " s" : "");
    }

    /** Arguments: tapes per kind, seed, [part of a kind's name], [-v], [-x FOLDER to write the recordings]. */
    public static void main(String[] args) throws Exception {
        List<String> words = new ArrayList<>(Arrays.asList(args));
        boolean verbose = words.remove("-v");
        int x = words.indexOf("-x");
        Path folder = x < 0 ? null : Path.of(words.get(x + 1));
        if (x >= 0) {
            words.subList(x, x + 2).clear();
        }
        int count = Integer.parseInt(words.get(0));
        long seed = Long.parseLong(words.get(1));
        String part = words.size() > 2 ? words.get(2) : "";
        Bench bench = new Bench();
        int[] exact = new int[3];
        int[] all = new int[3];
        for (Catalogue.Kind kind : Catalogue.kinds()) {
            if (!kind.name().contains(part)) {
                continue;
            }
            try {
                if (folder != null) {
                    write(folder, kind, count, seed);
                    continue;
                }
                Row row = bench.run(kind, count, seed);
                exact[kind.grade().ordinal()] += row.exact;
                all[kind.grade().ordinal()] += row.tapes;
                if (row.exact < row.tapes || verbose) {
                    System.out.println(line(row));
                }
            } catch (UnsupportedOperationException e) {
                System.out.println("not yet: " + kind.name());
            }
        }
        for (int g = 0; g < 3; g++) {
            System.out.printf("%s %.2f %%%n", Catalogue.Grade.values()[g], 100.0 * exact[g] / Math.max(1, all[g]));
        }
        System.out.printf(
                "delay: least %.1f, median %.1f, 95 %% %.1f, most %.1f ms%n",
                bench.delay(0), bench.delay(0.5), bench.delay(0.95), bench.delay(1));
        if (verbose) {
            System.out.print(bench.failures());
        }
    }

    private static void write(Path folder, Catalogue.Kind kind, int count, long seed) throws Exception {
        Files.createDirectories(folder);
        int n = 0;
        StringBuilder labels = new StringBuilder();
        for (Tape tape : Catalogue.tapes(kind, count, seed)) {
            String name = kind.name().replaceAll("[^A-Za-z0-9.-]", "_") + "-" + n++ + ".wav";
            WavWriter.write(folder.resolve(name), tape.samples());
            labels.append(name)
                    .append('\t')
                    .append(tape.expected)
                    .append('\t')
                    .append(kind.grade())
                    .append('\t')
                    .append(kind.name())
                    .append('\n');
        }
        Files.writeString(
                folder.resolve("labels.tsv"),
                labels,
                java.nio.file.StandardOpenOption.CREATE,
                java.nio.file.StandardOpenOption.APPEND);
    }
}
