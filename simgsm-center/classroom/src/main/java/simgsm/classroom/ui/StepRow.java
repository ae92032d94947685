package simgsm.classroom.ui;

import java.awt.BorderLayout;
import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.Lamp;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.glossary.GlossaryText;

/** A step: its text, the answer's field, the lamp, and the hint on demand; green as a whole when it is done. */
final class StepRow extends JPanel {
    private static final int STRIPE_UNITS = 5;

    private final String name;
    private final TextBundle words;
    private final Lamp lamp;
    private boolean isDone;

    /**
     * @param shown the step's text
     * @param hint its hint, not visible yet
     * @param answer the answer's field; empty for none
     * @param hinted run when the hint is opened
     */
    StepRow(
            String name,
            GlossaryText shown,
            GlossaryText hint,
            Optional<JComponent> answer,
            TextBundle words,
            Runnable hinted) {
        super(new BorderLayout());
        this.name = name;
        this.words = words;
        lamp = new Lamp(shown.getText());
        lamp.setName("lesson.lamp." + name);
        hint.setVisible(false);
        UserAction reveal = new UserAction("lesson.hint", words.of("lesson.hint"), () -> {
            hint.setVisible(!hint.isVisible());
            if (hint.isVisible()) {
                hinted.run();
            }
            revalidate();
        });
        JButton button = ComponentNames.name(
                new JButton(reveal), "lesson.hint.of." + name, words.of("lesson.hint") + ": " + shown.getText());
        List<Component> parts = new ArrayList<>(List.of(shown));
        answer.ifPresent(parts::add);
        parts.add(Arrange.row(Theme.HALF, Arrange.growing(lamp.wrapping()), button));
        parts.add(hint);
        add(Arrange.column(Theme.HALF, parts.toArray(Component[]::new)));
        Theme.styled(this, StepRow::dress);
    }

    private void dress() {
        setOpaque(isDone);
        setBackground(Theme.color(Ink.GOOD_WASH));
        setBorder(BorderFactory.createCompoundBorder(
                BorderFactory.createMatteBorder(
                        0, Theme.px(STRIPE_UNITS), 0, 0, Theme.color(isDone ? Ink.GOOD : Ink.LINE)),
                Theme.padding(4, 8, 4, 4)));
    }

    void show(LessonView.StepView view) {
        switch (view.state()) {
            case DONE -> lamp.show(StatusMark.TICK, Ink.GOOD, words.of("lesson.state.done"));
            case LOST -> lamp.show(StatusMark.SLASHED_RING, Ink.DANGER, words.of("lesson.state.lost"));
            case SPOILT -> lamp.show(StatusMark.SLASHED_RING, Ink.WARNING, words.of("lesson.state.spoilt"));
            case LATER -> lamp.show(StatusMark.RING, Ink.QUIET, words.of("lesson.state.later"));
            default -> {
                String state = words.of(view.tried() ? "lesson.state.tried" : "lesson.state.open");
                lamp.show(
                        StatusMark.RING,
                        view.tried() ? Ink.WARNING : Ink.QUIET,
                        String.join(", ", state, view.counts()).replaceFirst(", $", ""));
            }
        }
        if (isDone != (view.state() == LessonView.StepState.DONE)) {
            isDone = !isDone;
            dress();
        }
    }

    String step() {
        return name;
    }
}
