package simgsm.classroom.lesson;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import org.junit.jupiter.api.Test;
import simgsm.classroom.ui.ClassroomTexts;
import simgsm.console.Event;
import simgsm.console.TextBundle;

class ToolTextsTest {
    private final TextBundle english = ClassroomTexts.in(Locale.ENGLISH);
    private final TextBundle spanish = ClassroomTexts.in(Locale.forLanguageTag("es"));

    private static Event decode(String file, String keys) {
        return Event.of("decode")
                .with("status", 0)
                .with("output", file + "\t" + keys)
                .with(LessonTools.OPTIONS, file)
                .with("keys", keys)
                .with("count", keys.length());
    }

    @Test
    void heardKeysAreReportedWithTheirFileInTheStudentsLanguage() {
        assertEquals("noisy.wav: 3 keys heard: 12#", ToolTexts.of(decode("/tmp/a/noisy.wav", "12#"), english));
        assertEquals("far.wav: se oyen 3 teclas: 12#", ToolTexts.of(decode("far.wav", "12#"), spanish));
        assertEquals("far.wav: no se oye ninguna tecla", ToolTexts.of(decode("far.wav", ""), spanish));
    }

    @Test
    void aToolsErrorIsReportedWithoutItsNameAndOutput() {
        Event failed = Event.of("decode")
                .with("status", 1)
                .with("output", "simgsm-modem: notes.txt: no audio that can be read\nnotes.txt\t\t");
        assertEquals("decode: notes.txt: no audio that can be read", ToolTexts.of(failed, english));
    }

    @Test
    void anOptionThatWasNotTypedIsLeftOut() {
        Event failed = Event.of("drive")
                .with("status", 2)
                .with("output", "simrobot: --behaviour Mine: line 1: ';' expected; see --help");
        assertEquals("drive: Mine: line 1: ';' expected", ToolTexts.of(failed, english));
    }

    @Test
    void aCompilersErrorIsReportedWhole() {
        Event failed = Event.of("java").with("status", 1).with("output", "Forge.java:3: error\nint x");
        assertEquals("java: Forge.java:3: error\nint x", ToolTexts.of(failed, spanish));
    }

    @Test
    void aDriveIsReportedInFigures() {
        Event drive = Event.of("drive")
                .with("status", 0)
                .with("output", "")
                .with("name", "Mine")
                .with("travelled", "12.50")
                .with("collisions", 0)
                .with("near", "1.5")
                .with("far", "20.0");
        assertEquals(
                "Mine: 12.50 m travelled; 0 tenths of a second in collision; nearer than 40 cm for 1.5 % and farther than"
                        + " 80 cm for 20.0 % of the time.",
                ToolTexts.of(drive, english));
    }
}
