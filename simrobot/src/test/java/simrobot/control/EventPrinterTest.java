package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import simgsm.console.Console;
import simgsm.console.Event;

class EventPrinterTest {
    @Test
    void everythingAcceptedIsPrintedInOrderBeforeTheClose() {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        Console console = new Console(new PrintStream(out, true, StandardCharsets.UTF_8));
        console.ready(Event.of("ready"));
        StringBuilder expected = new StringBuilder("ready\n");
        try (EventPrinter printer = new EventPrinter(console)) {
            for (int i = 0; i < 1000; i++) {
                printer.accept(Event.of("e").with("n", i));
                expected.append("e n=").append(i).append('\n');
            }
        }
        assertEquals(expected.toString(), out.toString(StandardCharsets.UTF_8));
    }
}
