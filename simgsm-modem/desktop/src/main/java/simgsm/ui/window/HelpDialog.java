package simgsm.ui.window;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.KeyEvent;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.table.DefaultTableModel;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.lesson.LessonLibrary;
import simgsm.ui.Arrange;
import simgsm.ui.CommandGroup;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Drawing;
import simgsm.ui.ReadingArea;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.glossary.GlossaryList;
import simgsm.ui.lesson.LessonList;
import simgsm.ui.lesson.SheetPanel;

/** The help of a window, opened by F1: the window's purpose, all its keys, and the version. */
final class HelpDialog {
    private static final Dimension SIZE_UNITS = new Dimension(720, 520);
    private static final int KEY_MARGIN_UNITS = 24;
    private static final int MESSAGE_UNITS = 400;

    private HelpDialog() {}

    /**
     * The lessons and the action that begins one.
     *
     * @param hasSheets true shows the teacher's sheets, too
     * @param chosen empty if the program cannot begin one
     * @param question key of the text that is confirmed before
     */
    record Lessons(LessonLibrary library, boolean hasSheets, Optional<Consumer<String>> chosen, String question) {}

    /**
     * Opens help, lessons and glossary as tabs.
     *
     * @param about purpose of the window
     * @param version of the program
     * @param lessons that can be begun here
     * @param first text key of the tab shown first
     */
    static void open(
            JFrame frame,
            String about,
            String version,
            Locale language,
            Lessons lessons,
            SettingsPanel.Actions settings,
            String first) {
        TextBundle texts = DesktopTexts.in(language);
        JDialog dialog = new JDialog(frame, texts.of("window.help"));
        JTabbedPane tabs = ComponentNames.name(new JTabbedPane(), "help.tabs", texts.of("window.help"));
        tabs.addTab(texts.of("window.help"), content(frame.getRootPane(), about, version, texts));
        tabs.addTab(texts.of("lessons.title"), list(dialog, language, texts, lessons));
        tabs.addTab(texts.of("glossary.title"), new GlossaryList(language));
        SettingsPanel.Actions closing = settings.beforeLanguage(dialog::dispose);
        tabs.addTab(texts.of("settings.title"), new SettingsPanel(language, texts, closing));
        tabs.addTab(texts.of("about.title"), versions(frame.getTitle(), version, texts));
        tabs.setSelectedIndex(tabs.indexOfTab(texts.of(first)));
        dialog.setContentPane(tabs);
        UserAction close = new UserAction("help.close", texts.of("window.help.close"), dialog::dispose);
        close.bindInWindow(dialog.getRootPane(), KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0));
        close.bindInWindow(dialog.getRootPane(), KeyStroke.getKeyStroke(KeyEvent.VK_F1, 0));
        Display.resize(dialog, Theme.px(SIZE_UNITS.width), Theme.px(SIZE_UNITS.height));
        dialog.setLocationRelativeTo(frame);
        dialog.setVisible(true);
    }

    private static LessonList list(JDialog dialog, Locale language, TextBundle texts, Lessons lessons) {
        return new LessonList(lessons.library(), language, lessons.hasSheets(), new LessonList.Actions() {
            @Override
            public void open(String name) {
                begin(dialog, name, texts, lessons);
            }

            @Override
            public void showSheet(String title, String markdown) {
                sheet(dialog, title, markdown, texts);
            }
        });
    }

    /** The versions of program, Java and system, selectable for copying. */
    static JComponent versions(String title, String version, TextBundle texts) {
        JTextArea lines = wrapped(String.join(
                "\n",
                texts.of("about.program") + ": " + title + ", SimGSM " + version,
                texts.of("about.java") + ": " + System.getProperty("java.vm.name") + " "
                        + System.getProperty("java.vm.version") + ", " + System.getProperty("java.home"),
                texts.of("about.system") + ": " + System.getProperty("os.name") + " " + System.getProperty("os.version")
                        + ", " + System.getProperty("os.arch"),
                texts.of("about.licence") + ": MIT"));
        lines.setBorder(Theme.padding(12));
        return ComponentNames.name(lines, "about.versions", texts.of("about.title"));
    }

    /** A text of a message box in several lines, so that the box fits the screen at any zoom. */
    static JTextArea message(String text) {
        JTextArea lines = paragraph(text);
        lines.setSize(Theme.px(MESSAGE_UNITS), Short.MAX_VALUE);
        return lines;
    }

    private static JTextArea wrapped(String text) {
        JTextArea lines = new ReadingArea(text);
        return Theme.styled(lines, area -> area.setFont(Theme.base()));
    }

    /** Text on the window's surface. */
    static JTextArea paragraph(String text) {
        JTextArea lines = wrapped(text);
        lines.setOpaque(false);
        // Nimbus also paints the background of a text that is not opaque.
        return Theme.styled(lines, area -> area.setBackground(Theme.color(Ink.SURFACE, 0)));
    }

    /** Closed by Escape; the list of lessons remains open. */
    private static void sheet(JDialog list, String title, String markdown, TextBundle texts) {
        JDialog dialog = new JDialog(list, texts.of("lessons.sheet") + ": " + title);
        dialog.setContentPane(new SheetPanel(markdown, title));
        new UserAction("sheet.close", texts.of("window.help.close"), dialog::dispose)
                .bindInWindow(dialog.getRootPane(), KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0));
        dialog.setSize(list.getSize());
        dialog.setLocationRelativeTo(list);
        dialog.setVisible(true);
    }

    private static void begin(JDialog dialog, String name, TextBundle texts, Lessons lessons) {
        if (lessons.chosen().isPresent()) {
            int answer = JOptionPane.showConfirmDialog(
                    dialog,
                    message(texts.of(lessons.question())),
                    texts.of("lessons.title"),
                    JOptionPane.OK_CANCEL_OPTION);
            if (answer == JOptionPane.OK_OPTION) {
                dialog.dispose();
                lessons.chosen().get().accept(name);
            }
        } else {
            String folder = lessons.library()
                    .folder(name)
                    .map(own -> " --lessons " + own.getParent())
                    .orElse("");
            JOptionPane.showMessageDialog(
                    dialog,
                    message(texts.of("lessons.elsewhere", name + folder)),
                    texts.of("lessons.title"),
                    JOptionPane.PLAIN_MESSAGE);
        }
    }

    /** Makes the columns of groups and keys as wide as their widest rows. */
    private static void fit(JTable table) {
        table.setRowHeight(Theme.px(24));
        for (int column = 0; column < 2; column++) {
            int fitted = column;
            int width = IntStream.range(0, table.getRowCount())
                    .map(row -> Drawing.width(
                            Theme.base(), table.getValueAt(row, fitted).toString()))
                    .max()
                    .orElse(0);
            table.getColumnModel().getColumn(column).setMinWidth(width + Theme.px(KEY_MARGIN_UNITS));
            table.getColumnModel().getColumn(column).setMaxWidth(width + Theme.px(KEY_MARGIN_UNITS));
        }
    }

    /** The commands that have keys; a group is named in its first row. */
    private static DefaultTableModel rows(Component root, TextBundle texts) {
        DefaultTableModel rows = new DefaultTableModel(
                new Object[] {"", texts.of("window.help.key"), texts.of("window.help.action")}, 0);
        CommandGroup before = null;
        for (WindowCommands.Command command : WindowCommands.of(root)) {
            if (!command.keys().isEmpty()) {
                String group = command.group() == before ? "" : command.group().title(texts);
                before = command.group();
                rows.addRow(new Object[] {
                    group, command.keysText(texts), command.action().name()
                });
            }
        }
        return rows;
    }

    static JPanel content(Component root, String about, String version, TextBundle texts) {
        JTextArea text = paragraph(about);
        JTable table = new JTable(rows(root, texts));
        table.setDefaultEditor(Object.class, null);
        Theme.styled(table, HelpDialog::fit);
        JPanel column = Arrange.column(
                Theme.GRID,
                ComponentNames.name(text, "help.about", texts.of("window.help")),
                Arrange.growing(new JScrollPane(ComponentNames.name(table, "help.keys", texts.of("window.help.keys")))),
                Theme.label(texts.of("window.help.version", version), Theme::small, Ink.QUIET));
        JPanel content = new JPanel(new BorderLayout());
        content.setBorder(Theme.padding(12));
        Theme.styled(content, panel -> panel.setBackground(Theme.color(Ink.SURFACE)));
        content.add(column);
        return content;
    }
}
