package simgsm.cells.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.cells.app.ReportFile;
import simgsm.cells.mobile.MobileEvent;
import simgsm.cells.mobile.MobileEvent.CellLevel;
import simgsm.cells.town.TownPlace;

/** The file of measurement reports, line by line. */
class ReportFileTest {
    private final TownScene scene = new TownScene();

    @Test
    void aReportIsALineAndOtherEventsAreNone(@TempDir Path folder) throws Exception {
        scene.network.place("5550100", new TownPlace(500, 0));
        TownScene.Terminal terminal = scene.new Terminal("5550100");
        Path path = folder.resolve("reports.csv");
        try (ReportFile file = ReportFile.to(Optional.of(path))) {
            file.accept(new MobileEvent.SpeechGap(terminal.mobile, 200));
            file.accept(new MobileEvent.Reported(
                    terminal.mobile,
                    0,
                    new CellLevel("west", 44),
                    List.of(new CellLevel("east", 20), new CellLevel("south", 3)),
                    1,
                    2));
            List<String> lines = Files.readAllLines(path);
            assertEquals("time,number,cell,rxlev,rxqual,ta,neighbours", lines.get(0));
            assertEquals(2, lines.size());
            assertTrue(
                    lines.get(1).endsWith("Z," + terminal.mobile.number() + ",west,44,1,2,\"east:20,south:3\""),
                    lines.get(1));
        }
    }

    @Test
    void aFileThatCannotBeWrittenIsNamed(@TempDir Path folder) {
        Path path = folder.resolve("none").resolve("reports.csv");
        IOException refused = assertThrows(IOException.class, () -> ReportFile.to(Optional.of(path)));
        assertTrue(refused.getMessage().contains(path.toString()), refused.getMessage());
    }
}
