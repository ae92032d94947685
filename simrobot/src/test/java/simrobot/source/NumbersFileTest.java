package simrobot.source;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simrobot.process.BehaviourKind;
import simrobot.process.BehaviourList;

/** The numbers of processes in a folder stay. */
class NumbersFileTest {
    @TempDir
    Path folder;

    private final List<String> faults = new ArrayList<>();

    private final BehaviourFolder.Listener listener = new BehaviourFolder.Listener() {
        @Override
        public void failed(String name, int line, String text) {
            faults.add(name + " " + line + " " + text);
        }
    };

    private void write(String name) throws IOException {
        Files.writeString(
                folder.resolve(name + ".java"),
                "public class " + name + " implements simrobot.behaviour.Behaviour {\n"
                        + "    public simrobot.behaviour.Steering decide(simrobot.behaviour.Senses senses) {\n"
                        + "        return simrobot.behaviour.Steering.STOP;\n    }\n}\n");
    }

    private Path numbers() {
        return folder.resolve("numbers.txt");
    }

    private BehaviourFolder open(BehaviourList list) throws IOException {
        BehaviourFolder opened = BehaviourFolderTest.open(folder, list, listener);
        opened.keepNumbers();
        return opened;
    }

    private static Map<String, Integer> own(BehaviourList list) {
        Map<String, Integer> own = new TreeMap<>();
        list.numbered().tailMap(3).forEach((number, kind) -> own.put(kind.text(), number));
        return own;
    }

    @Test
    void aNumberOnceGivenStaysWhenFilesComeAndGo() throws IOException {
        write("LeftHand");
        write("Circle");
        BehaviourList list = new BehaviourList();
        list.setGoals(List.of(new BehaviourKind("goto Exit", null)));
        BehaviourFolder opened = open(list);
        assertEquals("3 Circle\n4 LeftHand\n", Files.readString(numbers()));
        assertEquals(Map.of("Circle", 3, "LeftHand", 4, "goto Exit", 5), own(list));
        write("Index");
        Files.delete(folder.resolve("Circle.java"));
        opened.scan();
        assertEquals("3 Circle\n4 LeftHand\n5 Index\n", Files.readString(numbers()));
        BehaviourList later = new BehaviourList();
        open(later);
        assertEquals(Map.of("LeftHand", 4, "Index", 5), own(later));
        write("Circle");
        open(later);
        assertEquals(Map.of("Circle", 3, "LeftHand", 4, "Index", 5), own(later));
    }

    @Test
    void twoProgramsOnOneFolderGiveTheSameNumbers() throws IOException {
        BehaviourList first = new BehaviourList();
        BehaviourList second = new BehaviourList();
        BehaviourFolder one = open(first);
        BehaviourFolder other = open(second);
        write("Zigzag");
        one.scan();
        write("Arc");
        other.scan();
        one.scan();
        assertEquals(Map.of("Zigzag", 3, "Arc", 4), own(first));
        assertEquals(own(first), own(second));
        Files.writeString(numbers(), "# of room 12\n\n  42 Arc\n7\tZigzag");
        write("More");
        one.scan();
        other.scan();
        assertEquals(Map.of("Arc", 42, "Zigzag", 7, "More", 3), own(second));
        assertEquals("# of room 12\n\n  42 Arc\n7\tZigzag\n3 More\n", Files.readString(numbers()));
        assertEquals(List.of(), faults);
    }

    @Test
    void eachOfNinetySevenProcessesHasANumberAndFurtherOnesHaveNone() throws IOException {
        BehaviourList list = new BehaviourList();
        for (int i = 0; i < 100; i++) {
            list.put(new BehaviourKind("P" + i, null));
        }
        assertEquals(97, own(list).size());
        assertEquals(99, list.numbered().lastKey());
        assertEquals(102, list.kinds().size());
    }

    @ParameterizedTest
    @CsvSource({
        "2 Arc,'expected a number from 3 to 99 and a name, such as 3 Circle, found 2 Arc'",
        "100 Arc,'expected a number from 3 to 99 and a name, such as 3 Circle, found 100 Arc'",
        "Arc,'expected a number from 3 to 99 and a name, such as 3 Circle, found Arc'",
        "7 Zigzag,'expected each number and each name once, found again: 7 Zigzag'",
        "8 Arc,'expected each number and each name once, found again: 8 Arc'"
    })
    void aDamagedFileIsRefusedWithItsNameAndLine(String line, String fault) throws IOException {
        Files.writeString(numbers(), "7 Arc\n" + line + "\n");
        IOException refused = assertThrows(IOException.class, () -> open(new BehaviourList()));
        assertEquals(numbers() + ": line 2: " + fault, refused.getMessage());
    }

    @Test
    void damageMeanwhileIsToldOnceAndLeavesTheNumbersAndTheFile() throws IOException {
        write("Arc");
        BehaviourList list = new BehaviourList();
        BehaviourFolder opened = open(list);
        Files.writeString(numbers(), "three Arc\n");
        opened.scan();
        opened.scan();
        assertEquals(
                List.of("numbers.txt 1 expected a number from 3 to 99 and a name, such as 3 Circle, found three Arc"),
                faults);
        assertEquals(Map.of("Arc", 3), own(list));
        assertEquals("three Arc\n", Files.readString(numbers()));
        Files.writeString(numbers(), "9 Arc\n");
        opened.scan();
        assertEquals(Map.of("Arc", 9), own(list));
        assertEquals(List.of(), list.faults());
    }

    @Test
    void withoutAFileThatCanBeWrittenNumbersHoldUntilTheEnd() throws IOException {
        Files.createSymbolicLink(numbers(), folder.resolve("nowhere").resolve("numbers.txt"));
        Files.createSymbolicLink(folder.resolve(".#Arc.java"), folder.resolve("nowhere"));
        write("Arc");
        BehaviourList list = new BehaviourList();
        BehaviourFolder opened = open(list);
        write("Aarc");
        opened.scan();
        opened.scan();
        assertEquals(Map.of("Arc", 3, "Aarc", 4), own(list));
        assertEquals(2, faults.size(), "one for each new name");
        assertTrue(
                faults.get(0)
                        .startsWith("numbers.txt 0 cannot be read or written, new numbers hold until SimRobot ends: "),
                faults.get(0));
    }

    @Test
    void aByteOrderMarkIsNoPartOfTheFirstLine() throws IOException {
        Files.writeString(numbers(), "\uFEFF3 Arc\n");
        write("Bow");
        BehaviourList list = new BehaviourList();
        open(list);
        assertEquals(Map.of("Bow", 4), own(list));
    }
}
