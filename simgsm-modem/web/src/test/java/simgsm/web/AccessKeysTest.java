package simgsm.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AccessKeysTest {
    private static final InetAddress HERE = InetAddress.getLoopbackAddress();
    private static final long SECOND = TimeUnit.SECONDS.toNanos(1);
    private static final String FORM = "expected name=key, a name of 1 to 64 letters, digits and _ . + -"
            + " and a key of 1 to 200 visible ASCII characters";

    @TempDir
    Path folder;

    private Path file;

    @BeforeEach
    void named() {
        file = folder.resolve("keys");
    }

    private AccessKeys keys(String text) throws IOException {
        return AccessKeys.read(Files.writeString(file, text));
    }

    private static int status(AccessKeys keys, String key, InetAddress from, long nowNanos) {
        return assertThrows(RequestException.class, () -> keys.operator(key, from, nowNanos))
                .answer()
                .status();
    }

    @Test
    void aKeyNamesItsOperator() throws Exception {
        AccessKeys keys = keys("\ufeff# for the class\n\nana=k#1==\r\n b.eñe = 2 \n");
        assertEquals("ana", keys.operator("k#1==", HERE, 0));
        assertEquals("b.eñe", keys.operator("2", HERE, 0));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "ana=k\\nben|, line 2: " + FORM,
                "ana=|, line 1: " + FORM,
                "=k|, line 1: " + FORM,
                "an a=k|, line 1: " + FORM,
                "ana=k 1|, line 1: " + FORM,
                "ana=ñ|, line 1: " + FORM,
                "ana=k\\n#\\nana=l|, line 3: expected each name once, found that of line 1",
                "ana=k\\nben=k|, line 2: expected each key once, found that of line 1",
                "# none|: expected a line name=key, found none"
            })
    void aComplaintNamesTheLineAndWhatWasExpectedButNoKey(String text, String complaint) {
        IOException refused = assertThrows(IOException.class, () -> keys(text.replace("\\n", "\n")));
        assertEquals(file + complaint, refused.getMessage());
    }

    @Test
    void ofGuessesAtOnceNoMoreAreReadThanOneAfterTheOther() throws Exception {
        // Many keys take so long to compare that guesses overlap.
        AccessKeys keys = keys(
                IntStream.range(0, 20_000).mapToObj(i -> "op" + i + "=k" + i).collect(Collectors.joining("\n")));
        List<Integer> statuses = IntStream.range(0, 1_000)
                .parallel()
                .mapToObj(i -> status(keys, "guess" + i, HERE, 0))
                .toList();
        assertEquals(10, Collections.frequency(statuses, 401));
    }

    @Test
    void wrongKeysAreRefusedAndAfterTenOnlyOneASecondIsRead() throws Exception {
        AccessKeys keys = keys("ana=k1");
        for (String wrong : new String[] {"", "k", "k2", "k11", "K1", "ana", "k1 ", "1", "ñ", "ana=k1"}) {
            assertEquals(401, status(keys, wrong, HERE, 0));
        }
        assertEquals(429, status(keys, "k2", HERE, SECOND - 1));
        assertEquals(429, status(keys, "k1", HERE, SECOND - 1));
        assertEquals(401, status(keys, "k2", InetAddress.getByName("10.0.0.1"), 0));
        assertEquals(401, status(keys, "k2", HERE, SECOND));
        assertEquals(429, status(keys, "k2", HERE, SECOND));
        assertEquals("ana", keys.operator("k1", HERE, 2 * SECOND));
        assertEquals("ana", keys.operator("k1", HERE, 2 * SECOND));
    }
}
