package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.octets.OctetString;
import simgsm.rr.FrequencyList;

/** libosmogsm and Wireshark read our frequency lists, and we read libosmogsm's, for random sets of each span. */
@Tag("peer")
class FrequencyListPeersTest {
    private static final int SETS = 600;

    @Test
    void libosmogsmAndWiresharkReadTheSameSetsAndWeReadTheirs(@TempDir Path folder) throws Exception {
        Peer.OSMO_BSC.require();
        Peer.TSHARK.require();
        Peer.PYTHON.require();
        List<TreeSet<Integer>> sets = sets();
        List<String> lines = new ArrayList<>();
        for (TreeSet<Integer> set : sets) {
            lines.add(FrequencyList.encode(set) + " " + text(set));
        }
        Path asked = Files.write(folder.resolve("lists.txt"), lines);
        Path told = folder.resolve("told.txt");
        Process peer = Peer.PYTHON
                .process(Peer.source("osmocom/frequency_lists.py"))
                .redirectInput(asked.toFile())
                .redirectOutput(told.toFile())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        assertEquals(0, peer.waitFor());
        List<String> answers = Files.readAllLines(told, StandardCharsets.UTF_8);
        assertEquals(sets.size(), answers.size());
        int foreign = 0;
        for (int i = 0; i < sets.size(); i++) {
            String[] answer = answers.get(i).split(" ");
            String expected = text(sets.get(i));
            assertEquals(expected, answer[1], "libosmogsm reads " + lines.get(i));
            assertEquals(expected, answer[2], "tshark reads " + lines.get(i));
            if (!answer[0].equals("-")) {
                foreign++;
                assertEquals(
                        expected,
                        text(new TreeSet<>(FrequencyList.decode(OctetString.ofHex(answer[0])))),
                        "libosmogsm's " + answer[0]);
            }
        }
        assertTrue(foreign > SETS / 2, foreign + " lists of libosmogsm");
        System.out.println("  " + SETS + " lists of ours, " + foreign + " of libosmogsm: read alike");
    }

    private static List<TreeSet<Integer>> sets() {
        Random random = new Random(44_018);
        return IntStream.range(0, SETS)
                .mapToObj(i -> {
                    int span = 16 << i % 7;
                    int first = random.nextInt(1025 - span);
                    return IntStream.range(0, 1 + random.nextInt(FrequencyList.SURE))
                            .mapToObj(each -> first + random.nextInt(span))
                            .collect(Collectors.toCollection(TreeSet::new));
                })
                .toList();
    }

    private static String text(TreeSet<Integer> set) {
        return set.stream().map(String::valueOf).collect(Collectors.joining(","));
    }
}
