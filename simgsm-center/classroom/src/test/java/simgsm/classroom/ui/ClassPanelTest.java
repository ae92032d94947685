package simgsm.classroom.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JToolTip;
import javax.swing.plaf.basic.BasicHTML;
import javax.swing.table.TableColumn;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;

/** The window of a class without a display. */
class ClassPanelTest {
    private boolean isInBrowsers;
    private static final ClassPanel.Frames NO_FRAMES = new ClassPanel.Frames() {
        @Override
        public void save(Component owner, String csv) {}

        @Override
        public void openLarge(Component beside, String title, JComponent content) {}
    };

    private final List<String> done = new ArrayList<>();

    @BeforeEach
    void light() {
        Theme.install(Appearance.LIGHT);
    }

    @Test
    void theTableOfAClassShowsTheNewestResults() {
        ClassPanel panel = new ClassPanel(Locale.ENGLISH, students(), NO_FRAMES);
        panel.show(view(row("5550100", true)));
        panel.show(view(row("5550101", true), row("5550100", false)));
        JTable table = (JTable) ComponentNames.find(panel, "class.table").orElseThrow();
        assertEquals(2, table.getRowCount());
        assertEquals("5550101", table.getValueAt(0, 0));
        assertEquals("5550101 leads: 12.5 s, 9 keys, 0 collisions", text(panel, "class.best"));
        assertEquals("01:15", text(panel, "class.clock"));
        assertEquals(List.of(), ComponentNames.unnamed(panel));
        assertEquals(
                "phone,name,robot,orders,keys,collisions,seconds,lesson,score,steps\r\n"
                        + "5550101,,5550200,1,9,0,12.5,tones,2,tones low pass\r\n"
                        + "5550100,,5550200,1,9,0,12.5,tones,2,tones low pass\r\n",
                panel.csv());
    }

    @Test
    void aNameThatAPupilTypedIsNoMarkup() {
        ClassPanel panel = new ClassPanel(Locale.ENGLISH, students(), NO_FRAMES);
        panel.show(view(row("5550100", "<html><b>ann", true)));
        JTable table = (JTable) ComponentNames.find(panel, "class.table").orElseThrow();
        for (Appearance appearance : Appearance.values()) {
            Theme.install(appearance);
            Theme.refresh(panel);
            JComponent cell = (JComponent) table.prepareRenderer(table.getCellRenderer(0, 1), 0, 1);
            assertNull(cell.getClientProperty(BasicHTML.propertyKey));
            JToolTip tip = table.createToolTip();
            tip.setTipText(cell.getToolTipText());
            assertNull(tip.getClientProperty(BasicHTML.propertyKey));
        }
        JComponent best = (JComponent) ComponentNames.find(panel, "class.best").orElseThrow();
        assertNull(best.getClientProperty(BasicHTML.propertyKey));
    }

    @Test
    void theTableOfAClassStartsStopsAndReplaysTheChosenStudent() {
        ClassPanel panel = new ClassPanel(Locale.ENGLISH, students(), NO_FRAMES);
        panel.show(view(row("5550100", true), row("5550101", false)));
        AbstractButton stop =
                (AbstractButton) ComponentNames.find(panel, "class.stop").orElseThrow();
        assertFalse(((AbstractButton) ComponentNames.find(panel, "class.start").orElseThrow()).isEnabled());
        stop.doClick();
        AbstractButton replay =
                (AbstractButton) ComponentNames.find(panel, "class.replay").orElseThrow();
        assertFalse(replay.isEnabled());
        JTextArea command =
                (JTextArea) ComponentNames.find(panel, "class.command").orElseThrow();
        assertTrue(command.getText().contains("--number N "));

        ((JTable) ComponentNames.find(panel, "class.table").orElseThrow()).setRowSelectionInterval(1, 1);
        replay.doClick();
        assertEquals(List.of("stop", "replay 5550101"), done);
        assertTrue(command.getText().contains("--number 5550101 "), command.getText());

        panel.show(view(row("5550101", true), row("5550100", false)));
        assertTrue(command.getText().contains("--number 5550101 "), "the chosen student stays chosen");
        ClassCommands page = panel.large();
        JTextArea large =
                (JTextArea) ComponentNames.find(page, "class.large.text").orElseThrow();
        assertTrue(large.getText().endsWith("5550101 drives robot 5550200"), large.getText());
        Theme.install(Appearance.DARK);
        try {
            Theme.refresh(page);
            assertEquals(Theme.color(Ink.CARD), page.getBackground());
            assertEquals(Theme.color(Ink.TEXT), large.getForeground());
        } finally {
            Theme.install(Appearance.LIGHT);
        }
    }

    @Test
    void theCommandsOfFortyStudentsFitASmallScreenAtEveryZoom() {
        List<ClassView.Row> rows = IntStream.range(0, 40)
                .mapToObj(i -> row("55501" + (i + 10), false))
                .toList();
        ClassCommands page = new ClassCommands(ClassroomTexts.in(Locale.ENGLISH), "java -jar simgsm-phone.jar", rows);
        try {
            for (double zoom : new double[] {1, 1.5, 2}) {
                Theme.zoomTo(zoom);
                page.setSize(1366, 740);
                page.doLayout();
                JTextArea text = (JTextArea)
                        ComponentNames.find(page, "class.large.text").orElseThrow();
                int height = text.getLineCount()
                        * text.getFontMetrics(text.getFont()).getHeight();
                assertTrue(height <= text.getHeight(), height + " at " + zoom);
            }
        } finally {
            Theme.zoomTo(1);
        }
    }

    @Test
    void aTypedNameStandsBesideTheNumberAndLeads() {
        ClassPanel panel = new ClassPanel(Locale.ENGLISH, students(), NO_FRAMES);
        panel.show(view(row("5550100", "Ana, \"=1\"", true), row("5550101", "=2+3", false)));
        JTable table = (JTable) ComponentNames.find(panel, "class.table").orElseThrow();
        assertEquals("5550100", table.getValueAt(0, 0));
        assertEquals("Ana, \"=1\"", table.getValueAt(0, 1));
        assertTrue(text(panel, "class.best").startsWith("Ana, \"=1\" leads"));
        assertTrue(panel.csv().contains("\r\n5550100,\"Ana, \"\"=1\"\"\",5550200,"), panel.csv());
        assertTrue(panel.csv().contains("\r\n5550101,'=2+3,5550200,"), panel.csv());
    }

    @Test
    void namesHaveTheRoomThatIsLeft() {
        ClassPanel panel = new ClassPanel(Locale.ENGLISH, students(), NO_FRAMES);
        panel.show(view(row("5550100", "Maria del Carmen Fernandez", true)));
        JTable table = (JTable) ComponentNames.find(panel, "class.table").orElseThrow();
        table.setSize(1200, 100);
        table.doLayout();
        for (int i = 0; i < table.getColumnCount(); i++) {
            TableColumn column = table.getColumnModel().getColumn(i);
            int most = i == 1 ? 1200 : 2 * column.getMinWidth();
            assertTrue(column.getWidth() <= most, table.getColumnName(i));
        }
        Component name = table.prepareRenderer(table.getCellRenderer(0, 1), 0, 1);
        assertTrue(name.getPreferredSize().width
                <= table.getColumnModel().getColumn(1).getWidth());
    }

    @Test
    void beforeAnyLessonANameOfUsualLengthIsWholeInTheWindowOfAClass() {
        ClassPanel panel = new ClassPanel(Locale.ENGLISH, students(), NO_FRAMES);
        panel.show(view(new ClassView.Row(
                List.of("5550100", "María del Carmen", "5550200", "1", "9", "0", "", "", ""), false, "")));
        JTable table = (JTable) ComponentNames.find(panel, "class.table").orElseThrow();
        table.setSize((int) (1920 * 0.34) - Theme.px(24), 100);
        table.doLayout();
        Component name = table.prepareRenderer(table.getCellRenderer(0, 1), 0, 1);
        assertTrue(name.getPreferredSize().width
                <= table.getColumnModel().getColumn(1).getWidth());
    }

    /** On a projector of 1280x720 the number of the robot gives way. */
    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void duringALessonANameIsWholeAndTheNumberOfTheRobotIsNot(String language) {
        Theme.install(Appearance.LIGHT, 0.7);
        try {
            ClassPanel panel = new ClassPanel(Locale.forLanguageTag(language), students(), NO_FRAMES);
            panel.show(view(new ClassView.Row(
                    List.of("5550100", "Ana Garc\u00eda", "5550200", "1", "9", "1", "", "twelve-keys", "2"),
                    true,
                    "")));
            JTable table = (JTable) ComponentNames.find(panel, "class.table").orElseThrow();
            table.setSize((int) (1280 * 0.34) - Theme.px(24), 100);
            table.doLayout();
            Component name = table.prepareRenderer(table.getCellRenderer(0, 1), 0, 1);
            assertTrue(name.getPreferredSize().width
                    <= table.getColumnModel().getColumn(1).getWidth());
            assertEquals(0, table.getColumnModel().getColumn(2).getWidth());
            assertTrue(text(panel, "class.best").endsWith(language.equals("en") ? " 1 collision" : " 1 choque"));
        } finally {
            Theme.install(Appearance.LIGHT);
        }
    }

    /** The windows of a class are 34 % of the screen wide, at the zoom that leaves room for the others. */
    @ParameterizedTest
    @CsvSource({"1366, 0.7, en", "1366, 0.7, es", "1920, 1.05, en", "1920, 1.05, es"})
    void noHeadingOfTheTableIsCut(int screen, double zoom, String language) {
        Theme.install(Appearance.LIGHT, zoom);
        try {
            ClassPanel panel = new ClassPanel(Locale.forLanguageTag(language), students(), NO_FRAMES);
            panel.show(view(row("5550100", true)));
            JTable table = (JTable) ComponentNames.find(panel, "class.table").orElseThrow();
            int least = 0;
            for (int i = 0; i < table.getColumnCount(); i++) {
                Component heading = table.getTableHeader()
                        .getDefaultRenderer()
                        .getTableCellRendererComponent(table, table.getColumnName(i), false, false, -1, i);
                assertTrue(table.getColumnModel().getColumn(i).getMinWidth() >= heading.getPreferredSize().width);
                least += table.getColumnModel().getColumn(i).getMinWidth();
            }
            int room = (int) (screen * 0.34) - Theme.px(24) - Theme.px(18);
            assertTrue(least <= room, least + " pixels in " + room);
        } finally {
            Theme.install(Appearance.LIGHT);
        }
    }

    @Test
    void resultsThatCannotBeSavedSayWhereAndWhy() {
        ClassPanel panel = new ClassPanel(Locale.ENGLISH, students(), new ClassPanel.Frames() {
            @Override
            public void save(Component owner, String csv) throws IOException {
                throw new AccessDeniedException("results.csv");
            }

            @Override
            public void openLarge(Component beside, String title, JComponent content) {}
        });
        ((AbstractButton) ComponentNames.find(panel, "class.save").orElseThrow()).doClick();
        Component notice = ComponentNames.find(panel, "class.notice").orElseThrow();
        assertTrue(notice.isVisible());
        assertEquals(
                "Not saved: results.csv: access denied",
                notice.getAccessibleContext().getAccessibleName());
    }

    private static String text(ClassPanel panel, String name) {
        return ((JLabel) ComponentNames.find(panel, name).orElseThrow()).getText();
    }

    private static ClassView.Row row(String phone, boolean isBest) {
        return row(phone, "", isBest);
    }

    private static ClassView.Row row(String phone, String name, boolean isBest) {
        return new ClassView.Row(
                List.of(phone, name, "5550200", "1", "9", "0", "12.5", "tones", "2"), isBest, "tones low pass");
    }

    private static ClassView view(ClassView.Row... rows) {
        return new ClassView(List.of(rows), ClassView.Phase.RUNNING, 75, Optional.empty());
    }

    @Test
    void theTextForStudentsIsNamedAsTheirCommandOrTheBrowsersLink() throws Exception {
        assertEquals("Each student's machine starts this; N is the number", nameOfCommand());
        isInBrowsers = true;
        assertEquals("Each student opens this link", nameOfCommand());
    }

    private String nameOfCommand() {
        return ComponentNames.find(new ClassPanel(Locale.ENGLISH, students(), NO_FRAMES), "class.command")
                .orElseThrow()
                .getAccessibleContext()
                .getAccessibleName();
    }

    private ClassActions students() {
        return new ClassActions() {
            @Override
            public void start() {
                done.add("start");
            }

            @Override
            public void stop() {
                done.add("stop");
            }

            @Override
            public void replay(String phone) {
                done.add("replay " + phone);
            }

            @Override
            public List<String> commands() {
                return List.of(
                        "x --number 5550100 --center 10.0.0.7:3003", "x --number 5550101 --center 10.0.0.7:3003");
            }

            @Override
            public String pattern() {
                return "x --number N --center 10.0.0.7:3003";
            }

            @Override
            public boolean isInBrowsers() {
                return isInBrowsers;
            }

            @Override
            public Optional<String> warning() {
                return Optional.empty();
            }
        };
    }

    /** Changed appearance, and colours and fonts of every component as of one that was built in it. */
    @ParameterizedTest
    @EnumSource
    void aPanelLooksInANewAppearanceAsOneThatWasBuiltInIt(Appearance next) throws Exception {
        Theme.install(next.next());
        ClassPanel changed = new ClassPanel(Locale.ENGLISH, students(), NO_FRAMES);
        changed.show(view(row("5550100", "<html>", true)));
        Theme.install(next);
        Theme.refresh(changed);
        ClassPanel built = new ClassPanel(Locale.ENGLISH, students(), NO_FRAMES);
        built.show(view(row("5550100", "<html>", true)));
        assertEquals(Looks.of(built), Looks.of(changed));
    }
}
