package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.air.Direction;
import simgsm.air.Element;
import simgsm.air.Layer3Type;

/** Pycrate's tables of layer 3 messages have the elements of ours: identifier, name, presence, format and fixed length. */
@Tag("peer")
class ElementTablesTest {
    /** Messages of short message control, which pycrate does not declare by element formats. */
    private static final int SHORT_MESSAGES = 9;

    @BeforeAll
    static void requirePycrate() {
        Peer.PYTHON.require();
        Peer.require(Files.isDirectory(Peer.LIBRARIES.resolve("python").resolve("pycrate_mobile")), "pycrate");
    }

    @Test
    void theElementsOfEveryMessageAreThoseOfPycrate(@TempDir Path folder) throws Exception {
        List<String> lines = new ArrayList<>();
        int messages = 0;
        for (Layer3Type type : Layer3Type.values()) {
            for (Direction direction : Direction.values()) {
                if (type.goes(direction) && type.discriminator() != SHORT_MESSAGES) {
                    String key = type.discriminator() + "\t" + type.code() + "\t" + direction;
                    lines.add("message\t" + key);
                    for (Element row : type.elements(direction)) {
                        lines.add(key + "\t" + String.join("\t", row.cells()));
                    }
                    messages++;
                }
            }
        }
        Path tables = Files.write(folder.resolve("tables.txt"), lines);

        String printed = Peer.PYTHON
                .run(Peer.source("pycrate_tables.py"), tables.toString())
                .expectSuccess()
                .strip();

        assertEquals(messages + " messages compared", printed);
    }
}
