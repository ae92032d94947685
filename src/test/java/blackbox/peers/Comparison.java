package blackbox.peers;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What the four receivers heard of the same recordings, counted by kind and printed as a table. */
final class Comparison {
    /** Of one receiver and one kind. */
    static final class Count {
        int keys;
        int missed;
        int extra;

        private void add(String expected, String heard) {
            int common = common(expected, heard);
            keys += expected.length();
            missed += expected.length() - common;
            extra += heard.length() - common;
        }
    }

    private record Recording(String kind, Path file, String keys) {}

    private final Path folder;
    private final Path spandsp;
    private final List<Recording> recordings = new ArrayList<>();
    private final Map<String, Map<ToneReceiver, Count>> counts = new LinkedHashMap<>();

    Comparison(Path folder) throws Exception {
        this.folder = folder;
        Peer.SOX.require();
        Peer.MULTIMON_NG.require();
        spandsp = ToneReceiver.spandsp(folder);
    }

    /** Adds a recording. @param keys what there is to be heard */
    void add(String kind, Path raw, String keys) {
        recordings.add(new Recording(kind, raw, keys));
    }

    void add(String kind, Sound sound, Treatment treatment) throws Exception {
        Path raw = sound.write(folder.resolve("recording" + recordings.size()));
        add(kind, treatment.of(raw, spandsp), sound.keys.toString());
    }

    /** The prompts behind each treatment. */
    void addSilent(Path prompts) throws Exception {
        for (Treatment treatment : Treatment.values()) {
            add(treatment.name(), treatment.of(prompts, spandsp), "");
        }
    }

    /** Runs all receivers and prints a row per kind. */
    Comparison run(String title) throws Exception {
        List<Path> files = recordings.stream().map(Recording::file).toList();
        long octets = 0;
        for (Path file : files) {
            octets += Files.size(file);
        }
        for (ToneReceiver receiver : ToneReceiver.values()) {
            List<String> heard = receiver.keys(files, spandsp);
            for (int i = 0; i < recordings.size(); i++) {
                Recording recording = recordings.get(i);
                counts.computeIfAbsent(recording.kind(), kind -> new EnumMap<>(ToneReceiver.class))
                        .computeIfAbsent(receiver, each -> new Count())
                        .add(recording.keys(), heard.get(i));
            }
        }
        System.out.printf("%s, %.2f h; keys missed + heard too often or falsely%n", title, octets / 57.6e6);
        System.out.printf("  %-34s %6s  %s%n", "", "keys", List.of(ToneReceiver.values()));
        counts.forEach((kind, row) -> {
            StringBuilder line = new StringBuilder();
            for (Count count : row.values()) {
                line.append(String.format("%6d +%4d", count.missed, count.extra));
            }
            System.out.printf("  %-34s %6d %s%n", kind, row.get(ToneReceiver.OURS).keys, line);
        });
        return this;
    }

    /** The count of a receiver over all kinds whose name begins so. */
    Count of(ToneReceiver receiver, String kindPrefix) {
        Count sum = new Count();
        counts.forEach((kind, row) -> {
            if (kind.startsWith(kindPrefix)) {
                sum.keys += row.get(receiver).keys;
                sum.missed += row.get(receiver).missed;
                sum.extra += row.get(receiver).extra;
            }
        });
        return sum;
    }

    /** Length of the longest common subsequence. */
    private static int common(String a, String b) {
        int[] above = new int[b.length() + 1];
        for (int i = 0; i < a.length(); i++) {
            int[] row = new int[b.length() + 1];
            for (int j = 0; j < b.length(); j++) {
                row[j + 1] = a.charAt(i) == b.charAt(j) ? above[j] + 1 : Math.max(above[j + 1], row[j]);
            }
            above = row;
        }
        return above[b.length()];
    }
}
