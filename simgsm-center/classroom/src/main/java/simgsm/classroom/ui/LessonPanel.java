package simgsm.classroom.ui;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.LayoutFocusTraversalPolicy;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingUtilities;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;
import simgsm.lesson.Lesson;
import simgsm.lesson.LessonAction;
import simgsm.lesson.LessonProgram;
import simgsm.lesson.LessonStep;
import simgsm.lesson.LessonTexts;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.Lamp;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.VerticalScrollPane;
import simgsm.ui.file.OpenDialog;
import simgsm.ui.glossary.Glossary;
import simgsm.ui.glossary.GlossaryText;
import simgsm.ui.pane.WrappedColumn;

/**
 * A lesson: task, prediction, steps with lamps, actions, question. The steps appear after the prediction, the question
 * after all steps. Needs no display.
 */
public final class LessonPanel extends JPanel {
    private static final int NOTICES_UNITS = 96;

    private final Lesson lesson;
    private final List<String> all;
    private final LessonTexts texts;
    private final TextBundle words;
    private final UnaryOperator<String> numbers;
    private final Glossary glossary;
    private final LessonActions actions;
    private final GlossaryText task;
    private final GlossaryText term;
    private final GlossaryText question;
    private final GlossaryText notice;
    private final JComponent work;
    private final JTextField student = new JTextField();
    private final List<StepRow> rows = new ArrayList<>();
    private final List<ProgramButton> programs = new ArrayList<>();
    private final GlossaryText score;
    private final Lamp success;
    private long shownScore;
    private final UserAction closeNotices;
    private JComponent told;
    private String closedNotice = "";

    /**
     * @param all names of all lessons in order
     * @param numbers replaces names in braces by the student's numbers
     * @param actions performs the student's actions
     */
    public LessonPanel(
            Lesson lesson,
            LessonTexts texts,
            List<String> all,
            Locale language,
            UnaryOperator<String> numbers,
            LessonActions actions) {
        super(new BorderLayout());
        this.lesson = lesson;
        this.texts = texts;
        this.all = all;
        this.numbers = numbers;
        this.actions = actions;
        words = ClassroomTexts.in(language);
        closeNotices = new UserAction("lesson.notice.close", words.of("lesson.notice.close"), this::closeNotices)
                .with(Symbol.CLOSE.icon());
        glossary = Glossary.in(language);
        term = GlossaryText.ofExplanations("lesson.term");
        task = text("lesson.task");
        question = text("lesson.question");
        notice = text("lesson.notice");
        score = text("lesson.score");
        success = new Lamp(words.of("lesson.success"));
        success.show(StatusMark.TICK, Ink.GOOD, words.of("lesson.success"));
        success.setName("lesson.success");
        success.setVisible(false);
        Theme.styled(success, lamp -> lamp.setFont(Theme.title()));
        task.show(numbers.apply(texts.of("task")));
        term.setVisible(false);
        question.setVisible(false);
        notice.setVisible(false);
        work = work();
        work.setVisible(false);
        JPanel column = Arrange.column(Theme.GRID, heading(), task, prediction(), work, Arrange.spring());
        column.setBorder(Theme.padding(12));
        add(scrolled(column), BorderLayout.CENTER);
        add(notices(), BorderLayout.SOUTH);
        Theme.styled(this, panel -> panel.setBackground(Theme.color(Ink.SURFACE)));
        setFocusTraversalPolicyProvider(true);
        setFocusTraversalPolicy(new LinksLast());
    }

    /**
     * Lets Tab reach all fields and buttons before the first text with links, so that typed text enters the next field.
     */
    private final class LinksLast extends LayoutFocusTraversalPolicy {
        LinksLast() {
            Comparator<Component> isText = Comparator.comparing(GlossaryText.class::isInstance);
            setComparator(isText.thenComparing(
                    each -> ComponentNames.all(LessonPanel.this).toList().indexOf(each)));
        }
    }

    private static JScrollPane scrolled(JPanel column) {
        JScrollPane scroll = new VerticalScrollPane(new WrappedColumn(column)).bare();
        // A disappearing scroll bar would re-wrap the text.
        scroll.setVerticalScrollBarPolicy(ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS);
        return scroll;
    }

    /** Reserves one constant height for notice and term, so that neither moves a button. */
    private JComponent notices() {
        JPanel texts = Arrange.column(Theme.HALF, notice, term);
        texts.setBorder(Theme.padding(8, 12, 8, 12));
        JScrollPane place = new VerticalScrollPane(new WrappedColumn(texts));
        place.setVerticalScrollBarPolicy(ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS);
        JButton close = ComponentNames.name(new JButton(closeNotices), "lesson.notice.close", closeNotices.name());
        close.setHideActionText(true);
        told = Arrange.row(Theme.HALF, Arrange.growing(place), Arrange.column(Theme.HALF, close, Arrange.spring()));
        JPanel reserved = new JPanel(new BorderLayout()) {
            @Override
            public Dimension getPreferredSize() {
                return new Dimension(0, Theme.px(NOTICES_UNITS));
            }
        };
        reserved.setOpaque(false);
        reserved.add(told);
        showNotices();
        return reserved;
    }

    /** Shows the frame of notice and term, and the button that closes it, only around a text. */
    private void showNotices() {
        told.setVisible(notice.isVisible() || term.isVisible());
        revalidate();
    }

    /** Keeps a closed notice hidden until the next one. */
    private void closeNotices() {
        closedNotice = notice.getText();
        notice.setVisible(false);
        term.setVisible(false);
        showNotices();
    }

    private GlossaryText text(String name) {
        return new GlossaryText(name, Optional.of(glossary), this::explain);
    }

    private void explain(String name) {
        glossary.find(name).ifPresent(found -> {
            term.show(name + ": " + found);
            term.setVisible(true);
            showNotices();
        });
    }

    private JComponent heading() {
        GlossaryText title = text("lesson.title").bold();
        title.show(texts.of("title"));
        GlossaryText about = GlossaryText.ofExplanations("lesson.about");
        about.show(words.of("lesson.about", Integer.toString(lesson.minutes()))
                + (hasTerms() ? " " + words.of("lesson.terms") : ""));
        int at = all.indexOf(lesson.name());
        JButton previous = other("lesson.previous", at > 0 ? all.get(at - 1) : "");
        JButton next = other("lesson.next", at >= 0 && at + 1 < all.size() ? all.get(at + 1) : "");
        JButton again = other("lesson.again", lesson.name());
        return Arrange.column(
                Theme.HALF, title, Arrange.row(Theme.HALF, previous, next, Arrange.spring(), again), about);
    }

    /** True if a text visible at the beginning or after the prediction has an underlined word. */
    private boolean hasTerms() {
        return Stream.concat(
                        Stream.of("title", "task", "predict"),
                        lesson.steps().stream().map(step -> "step " + step.name()))
                .anyMatch(key -> glossary.hasTerms(texts.of(key)));
    }

    private JButton other(String key, String name) {
        UserAction action = new UserAction(key, words.of(key), () -> actions.open(name));
        JButton button = ComponentNames.name(new JButton(action), key, words.of(key + ".why"));
        button.setToolTipText(words.of(key + ".why"));
        button.setEnabled(!name.isEmpty());
        return button;
    }

    /** Focuses the prediction. */
    void focusFirst() {
        ComponentNames.find(this, "lesson.predict").ifPresent(Component::requestFocusInWindow);
    }

    private JComponent prediction() {
        GlossaryText asked = text("lesson.predict.text");
        asked.show(words.of("lesson.predict") + " " + numbers.apply(texts.of("predict")));
        return Arrange.column(Theme.HALF, asked, field("lesson.predict", words.of("lesson.predict"), actions::predict));
    }

    /** A field with a button; Enter has the same effect. */
    private JComponent field(String id, String name, java.util.function.Consumer<String> done) {
        JTextField field = ComponentNames.name(new JTextField(), id, name);
        UserAction give = new UserAction(id + ".give", words.of("lesson.give"), () -> {
            if (!field.getText().isBlank()) {
                done.accept(field.getText().strip());
            }
        });
        field.addActionListener(give);
        JButton button = ComponentNames.name(new JButton(give), id + ".give", words.of("lesson.give") + ": " + name);
        return Arrange.row(Theme.HALF, Arrange.growing(field), button);
    }

    private JComponent work() {
        List<Component> parts = new ArrayList<>();
        for (LessonProgram program : lesson.programs()) {
            ProgramButton button = new ProgramButton(program);
            programs.add(button);
            parts.add(button.button);
        }
        addActions(parts);
        for (LessonStep step : lesson.steps()) {
            parts.add(row(step));
            addActions(parts);
        }
        parts.add(success);
        parts.add(score);
        parts.add(question);
        ComponentNames.name(student, "lesson.student", words.of("lesson.student"));
        UserAction save = new UserAction(
                "lesson.save",
                words.of("lesson.save"),
                () -> actions.save(student.getText().strip()));
        parts.add(Theme.label(words.of("lesson.student"), () -> GlossaryText.font(false), Ink.QUIET));
        parts.add(Arrange.row(
                Theme.HALF,
                Arrange.growing(student),
                ComponentNames.name(new JButton(save), "lesson.save", words.of("lesson.save"))));
        return Arrange.column(Theme.GRID, parts.toArray(Component[]::new));
    }

    private StepRow row(LessonStep step) {
        GlossaryText shown = text("lesson.step." + step.name()).bold();
        shown.show(rows.size() + 1 + ". " + numbers.apply(texts.of("step " + step.name())));
        GlossaryText hint = text("lesson.hint." + step.name());
        hint.show(numbers.apply(texts.of("hint " + step.name())));
        Optional<JComponent> answer = step.answer()
                .map(name -> field("lesson.answer." + name, shown.getText(), typed -> actions.answer(name, typed)));
        StepRow row = new StepRow(step.name(), shown, hint, answer, words, () -> actions.hint(step.name()));
        rows.add(row);
        return row;
    }

    /** Adds the actions that follow the steps added so far. */
    private void addActions(List<Component> parts) {
        lesson.actions().stream()
                .filter(action -> action.stepsAbove() == rows.size())
                .forEach(action -> parts.add(action(action)));
    }

    private JComponent action(LessonAction action) {
        String name = numbers.apply(texts.of("action " + action.name()));
        String id = "lesson.action." + action.name();
        if (action.input() instanceof LessonAction.Text || action.input() instanceof LessonAction.Range) {
            GlossaryText label = text(id + ".text");
            label.show(name);
            return Arrange.column(Theme.HALF, label, field(id, name, input -> actions.act(action.name(), input)));
        }
        UserAction press = new UserAction(id, name, () -> {
            if (action.input() instanceof LessonAction.File file) {
                choose(action.name(), chooser(name, file.ending()));
            } else {
                actions.act(action.name(), "");
            }
        });
        return ComponentNames.name(new WrappingButton(press), id, name);
    }

    /** Shows files with this extension first, and on demand all. */
    JFileChooser chooser(String title, String ending) {
        List<String> endings = ending.isEmpty() ? List.of() : List.of(ending);
        JFileChooser chooser = OpenDialog.question(Optional.empty(), words.of("lesson.files", ending), endings);
        chooser.setDialogTitle(title);
        return chooser;
    }

    private void choose(String action, JFileChooser chooser) {
        OpenDialog.ask(this, chooser)
                .ifPresent(file -> actions.act(action, file.toAbsolutePath().toString()));
    }

    /** Shows the newest state; called on the event thread. */
    public void show(LessonView view) {
        work.setVisible(view.isPredicted());
        if (view.isPredicted()) {
            close("lesson.predict");
        }
        rows.forEach(row -> row.show(view.byName().get(row.step())));
        lesson.steps().stream()
                .filter(step -> view.byName().get(step.name()).state() == LessonView.StepState.DONE)
                .forEach(step -> step.answer().ifPresent(answer -> close("lesson.answer." + answer)));
        if (view.isPredicted() && view.score() != shownScore) {
            shownScore = view.score();
            SwingUtilities.invokeLater(() -> scrollToOpen(view));
        }
        programs.forEach(button -> button.show(view.running().contains(button.name)));
        score.show(words.of(
                "lesson.score", view.score(), Integer.toString(view.steps().size()), Long.toString(view.seed())));
        success.setVisible(view.isDone());
        question.show(words.of("lesson.question") + " " + numbers.apply(texts.of("question")));
        question.setVisible(view.isDone());
        if (!view.notice().equals(notice.getText())) {
            closedNotice = "";
            term.setVisible(false);
        }
        notice.show(view.notice());
        notice.setVisible(!view.notice().equals(closedNotice));
        showNotices();
        repaint();
    }

    /** Brings the first step that is open into view, or the question when all are done; called when a step is done. */
    private void scrollToOpen(LessonView view) {
        JComponent next = rows.stream()
                .filter(row -> view.byName().get(row.step()).state() != LessonView.StepState.DONE)
                .findFirst()
                .<JComponent>map(row -> row)
                .orElse(question);
        next.scrollRectToVisible(new Rectangle(next.getSize()));
    }

    /** Makes an accepted answer read-only. */
    private void close(String field) {
        ComponentNames.find(this, field).ifPresent(found -> ((JTextField) found).setEditable(false));
        ComponentNames.find(this, field + ".give").ifPresent(button -> button.setEnabled(false));
    }

    /**
     * Starts or stops a program that the lesson does not start itself, and restarts one after its window was closed.
     */
    private final class ProgramButton {
        private final String name;
        private final boolean isLater;
        private final JButton button;
        private boolean isRunning;

        ProgramButton(LessonProgram program) {
            name = program.name();
            isLater = program.isLater();
            button = new WrappingButton(new UserAction("lesson.program." + name, "", () -> {
                if (isRunning) {
                    actions.stopProgram(name);
                } else {
                    actions.startProgram(name);
                }
            }));
            show(false);
        }

        void show(boolean running) {
            isRunning = running;
            button.setVisible(isLater || !running);
            String title = texts.find("program " + name).orElse(name);
            String text = words.of(running ? "lesson.program.stop" : "lesson.program.start", title);
            button.setText(text);
            ComponentNames.name(button, "lesson.program." + name, text);
        }
    }
}
