package simgsm.classroom.ui;

import java.awt.BorderLayout;
import java.awt.Component;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.ListSelectionModel;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.DefaultTableModel;
import javax.swing.table.TableColumn;
import simgsm.console.Program;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.CopiedText;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Drawing;
import simgsm.ui.DressedPanel;
import simgsm.ui.ReadingArea;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.glossary.GlossaryText;

/**
 * A class: the challenge with its clock, the ranked results, and the commands of the students' machines. Needs no
 * display.
 */
public final class ClassPanel extends DressedPanel {
    private static final List<String> COLUMNS =
            List.of("phone", "name", "robot", "orders", "keys", "collisions", "seconds", "lesson", "score");
    /** Minimum content of each column; names and lessons take the rest. */
    private static final List<String> SAMPLES =
            List.of("5550100", "Maria", "5550200", "", "", "", "1234.5", "twelve", "");
    /** Columns that a narrow table hides, the least important first. */
    private static final List<String> OMITTED = List.of("robot", "orders", "keys", "lesson");

    private static final int CELL_MARGIN_UNITS = 10;

    private static final int ROW_UNITS = 26;
    private static final int CLOCK_UNITS = 22;
    private static final int SECONDS_PER_MINUTE = 60;

    private final Locale language;
    private final TextBundle words;
    private final ClassActions actions;
    private final Frames frames;
    private final DefaultTableModel model;
    private final JTable table;
    /** Minimum width of each column in pixels. */
    private final int[] least = new int[COLUMNS.size()];

    private final JLabel clock = new JLabel("00:00");
    private final JLabel best = new JLabel(" ");
    private final JTextArea command;
    private final GlossaryText notice = new GlossaryText("class.notice", Optional.empty(), term -> {});
    private final UserAction start;
    private final UserAction stop;
    private final UserAction replay;
    private List<ClassView.Row> rows = List.of();

    /** Opens dialogs and windows for the panel. */
    public interface Frames {
        /** Asks for a file and saves to it. */
        void save(Component owner, String csv) throws IOException;

        /** Fills the screen with a content. */
        void openLarge(Component beside, String title, JComponent content);
    }

    public ClassPanel(Locale language, ClassActions actions, Frames frames) {
        this.language = language;
        this.actions = actions;
        this.frames = frames;
        words = ClassroomTexts.in(language);
        model = new DefaultTableModel(
                COLUMNS.stream().map(column -> words.of("class." + column)).toArray(), 0);
        table = ComponentNames.name(
                new JTable(model) {
                    @Override
                    public void doLayout() {
                        fit();
                        super.doLayout();
                    }
                },
                "class.table",
                words.of("class.title"));
        table.setDefaultEditor(Object.class, null);
        // Nimbus puts its own renderer back whenever the look changes.
        Theme.styled(table, all -> all.setDefaultRenderer(Object.class, new Cell()));
        table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.getSelectionModel().addListSelectionListener(event -> chosen());
        start = action("start", Symbol.PLAY, actions::start);
        stop = action("stop", Symbol.BRAKE, actions::stop);
        replay = action("replay", Symbol.PLAY, this::replay);
        ComponentNames.name(clock, "class.clock", words.of("class.clock"));
        ComponentNames.name(best, "class.best", words.of("class.best.name"));
        command = ComponentNames.name(new ReadingArea(actions.pattern()), "class.command", words.of(heading()));
        add(content(), BorderLayout.CENTER);
        actions.warning().ifPresent(notice::show);
        notice.setVisible(actions.warning().isPresent());
        dress();
        show(new ClassView(List.of(), ClassView.Phase.FREE, 0, Optional.empty()));
    }

    private JComponent content() {
        JButton save = button(action("save", Symbol.SAVE, this::save));
        JButton copy = button(action("copy", Symbol.LIST, this::copy));
        JButton large = button(action("large", Symbol.FIT, this::showLarge));
        GlossaryText about = new GlossaryText("class.about", Optional.empty(), term -> {});
        about.show(words.of("class.about"));
        return Arrange.column(
                Theme.GRID,
                about,
                Arrange.row(Theme.GRID, button(start), button(stop), Arrange.spring(), clock),
                best,
                Arrange.growing(new JScrollPane(table)),
                // the table shrinks for a notice, so that no button moves
                notice,
                Arrange.row(Theme.GRID, button(replay), save, Arrange.spring()),
                new JLabel(words.of(heading())),
                command,
                Arrange.row(Theme.GRID, copy, large, Arrange.spring()));
    }

    private String heading() {
        return actions.isInBrowsers() ? "class.link" : "class.commands";
    }

    private UserAction action(String id, Symbol symbol, Runnable task) {
        return new UserAction("class." + id, words.of("class." + id), task)
                .described(words.of("class." + id + ".why"))
                .with(symbol.icon());
    }

    private static JButton button(UserAction action) {
        return ComponentNames.name(new JButton(action), action.id(), action.name());
    }

    /** Shows the newest results; keeps the selected student. */
    public void show(ClassView view) {
        clock.setText(String.format(
                Locale.ROOT, "%02d:%02d", view.seconds() / SECONDS_PER_MINUTE, view.seconds() % SECONDS_PER_MINUTE));
        start.setEnabled(view.phase() != ClassView.Phase.RUNNING);
        stop.setEnabled(view.phase() == ClassView.Phase.RUNNING);
        view.notice().ifPresent(this::tell);
        if (!view.rows().equals(rows)) {
            Optional<String> chosen = chosenPhone();
            rows = view.rows();
            model.setRowCount(0);
            for (ClassView.Row row : rows) {
                model.addRow(row.cells().toArray());
            }
            chosen.ifPresent(this::choose);
            best.setText(rows.stream()
                    .filter(ClassView.Row::isBest)
                    .findFirst()
                    .map(row -> words.of(
                            "class.best",
                            row.student(),
                            row.cells().get(6),
                            row.cells().get(4),
                            Integer.valueOf(row.cells().get(5))))
                    .orElse(words.of("class.best.none")));
        }
        chosen();
    }

    private void choose(String phone) {
        for (int i = 0; i < rows.size(); i++) {
            if (rows.get(i).phone().equals(phone)) {
                table.setRowSelectionInterval(i, i);
            }
        }
    }

    private Optional<String> chosenPhone() {
        int row = table.getSelectedRow();
        return row < 0 || row >= rows.size()
                ? Optional.empty()
                : Optional.of(rows.get(row).phone());
    }

    /** Shows the command of the selected student, or the pattern for all. */
    private void chosen() {
        Optional<String> phone = chosenPhone();
        replay.setEnabled(phone.isPresent());
        String shown = phone.flatMap(number -> actions.commands().stream()
                        .filter(line -> line.contains("--number " + number + " "))
                        .findFirst())
                .orElse(actions.pattern());
        if (!shown.equals(command.getText())) {
            command.setText(shown);
            revalidate();
        }
    }

    private void replay() {
        chosenPhone().ifPresent(phone -> {
            try {
                actions.replay(phone);
            } catch (IOException e) {
                tell(words.of("class.replay.failed", e.getMessage()));
            }
        });
    }

    private void tell(String what) {
        notice.show(what);
        notice.setVisible(true);
        revalidate();
    }

    /** Copies all commands, a line each. */
    private void copy() {
        boolean isCopied = CopiedText.copy(String.join("\n", actions.commands()) + "\n");
        tell(
                isCopied
                        ? words.of("class.copied", actions.commands().size())
                        : DesktopTexts.in(language).of("clipboard.busy"));
    }

    private void showLarge() {
        frames.openLarge(this, words.of(heading()), large());
    }

    ClassCommands large() {
        return new ClassCommands(words, actions.pattern(), rows);
    }

    private void save() {
        try {
            frames.save(this, csv());
        } catch (IOException e) {
            tell(words.of("class.save.failed", Program.describe(e)));
        }
    }

    /** The results with a header of column names. */
    String csv() {
        List<String> lines = new ArrayList<>();
        lines.add(String.join(",", COLUMNS) + ",steps");
        rows.stream().map(ClassView.Row::line).forEach(lines::add);
        return String.join("\r\n", lines) + "\r\n";
    }

    @Override
    protected void dress() {
        setBorder(Theme.padding(12));
        setBackground(Theme.color(Ink.SURFACE));
        table.setRowHeight(Theme.px(ROW_UNITS));
        for (int i = 0; i < COLUMNS.size(); i++) {
            TableColumn column = table.getColumnModel().getColumn(i);
            int heading = table.getTableHeader()
                    .getDefaultRenderer()
                    .getTableCellRendererComponent(table, column.getHeaderValue(), false, false, -1, i)
                    .getPreferredSize()
                    .width;
            int sample = Drawing.width(Theme.strong(), SAMPLES.get(i)) + Theme.px(CELL_MARGIN_UNITS);
            least[i] = Math.max(heading, sample);
            column.setMinWidth(least[i]);
            column.setPreferredWidth(least[i]);
        }
        clock.setFont(Theme.monoStrong().deriveFont(Theme.exact(CLOCK_UNITS)));
        best.setFont(Theme.strong());
        command.setFont(Theme.mono());
        command.setBackground(Theme.color(Ink.CARD));
        command.setForeground(Theme.color(Ink.TEXT));
        command.setBorder(Theme.padding(6));
        Stream.of(clock, best).forEach(label -> label.setForeground(Theme.color(Ink.TEXT)));
    }

    /**
     * Hides the least important columns while the table is narrower than all minimum widths; names take the rest, and
     * are not narrowed by the names of lessons.
     */
    private void fit() {
        int lesson = COLUMNS.indexOf("lesson");
        int[] wanted = least.clone();
        if (rows.stream().anyMatch(row -> !row.cells().get(lesson).isEmpty())) {
            wanted[lesson] *= 2;
            wanted[1] = Math.min(2 * least[1], Math.max(least[1], longestName()));
        }
        int missing = IntStream.of(wanted).sum() - table.getWidth();
        for (String each : OMITTED) {
            int i = COLUMNS.indexOf(each);
            int shown = missing > 0 ? 0 : least[i];
            missing -= shown == 0 ? wanted[i] : 0;
            TableColumn column = table.getColumnModel().getColumn(i);
            column.setMinWidth(0);
            column.setMaxWidth(shown == 0 ? 0 : Integer.MAX_VALUE);
            column.setMinWidth(shown);
        }
        table.getColumnModel().getColumn(lesson).setPreferredWidth(wanted[lesson]);
        List<TableColumn> all = Collections.list(table.getColumnModel().getColumns());
        TableColumn names = all.remove(COLUMNS.indexOf("name"));
        int others = all.stream().mapToInt(TableColumn::getPreferredWidth).sum();
        names.setPreferredWidth(Math.max(names.getMinWidth(), table.getWidth() - others));
    }

    private int longestName() {
        return Theme.px(CELL_MARGIN_UNITS)
                + rows.stream()
                        .mapToInt(
                                row -> Drawing.width(Theme.strong(), row.cells().get(1)))
                        .max()
                        .orElse(0);
    }

    /** Marks the best run by weight and background. */
    private final class Cell extends DefaultTableCellRenderer {
        @Override
        public Component getTableCellRendererComponent(
                JTable all, Object value, boolean selected, boolean focused, int row, int column) {
            super.getTableCellRendererComponent(all, value, selected, focused, row, column);
            boolean isBest = row < rows.size() && rows.get(row).isBest();
            setFont(isBest ? Theme.strong() : Theme.base());
            setBorder(Theme.padding(0, 6, 0, 2));
            boolean isLesson = column >= COLUMNS.indexOf("lesson") && row < rows.size();
            setToolTipText(isLesson ? rows.get(row).steps() : String.valueOf(value));
            if (!selected) {
                setBackground(Theme.color(isBest ? Ink.ACCENT_WASH : Ink.CARD));
            }
            return this;
        }
    }
}
