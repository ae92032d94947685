package simrobot.ui.inspector;

import java.awt.BorderLayout;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.drawing.NumberTexts;
import simrobot.drawing.RobotPreview;
import simrobot.ui.EventThread;
import simrobot.ui.OperatorActions;
import simrobot.ui.TextLine;
import simrobot.ui.ToolButtons;
import simrobot.ui.floor.WorldView;
import vericommand.Pose;

/**
 * The form for a new robot: its name, its modem's number and its place, typed or pressed on the floor; without a place
 * the robot starts at the first free home.
 */
final class NewRobotForm extends JPanel {
    private static final String FIRST_NUMBER = "5550200";

    private final TextBundle texts;
    private final OperatorActions operator;
    private final WorldView view;
    private final JTextField name = new JTextField(8);
    private final JTextField number = new JTextField(8);
    private final JTextField x = new JTextField(2);
    private final JTextField y = new JTextField(2);
    private final JTextField heading = new JTextField(2);
    private final TextLine problem = new TextLine("newcomer.problem", Theme::small, Ink.DANGER)
            .shrinking()
            .overTwoRows();
    private String addedName = "";

    NewRobotForm(TextBundle texts, OperatorActions operator, WorldView view) {
        super(new BorderLayout());
        this.texts = texts;
        this.operator = operator;
        this.view = view;
        setOpaque(false);
        UserAction add = new UserAction("newcomer.add", texts.of("newcomer.add"), this::add);
        UserAction cancel = new UserAction("newcomer.cancel", texts.of("newcomer.cancel"), this::close);
        add.bind(this, JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0));
        cancel.bind(this, JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0));
        JPanel buttons = Arrange.row(
                Theme.HALF,
                Arrange.spring(),
                ToolButtons.named(new JButton(), cancel),
                ToolButtons.named(new JButton(), add));
        JPanel rows = Arrange.column(
                6,
                labelled("newcomer.name", name),
                labelled("newcomer.number", number),
                Arrange.row(
                        Theme.HALF,
                        Arrange.growing(labelled("newcomer.x", x)),
                        Arrange.growing(labelled("newcomer.y", y)),
                        Arrange.growing(labelled("newcomer.heading", heading))),
                hint(),
                problem,
                buttons);
        add(new Card(texts.of("newcomer.title"), rows));
        setVisible(false);
    }

    private TextLine hint() {
        TextLine hint = new TextLine("newcomer.hint", Theme::small, Ink.QUIET)
                .shrinking()
                .overTwoRows();
        hint.show(texts.of("newcomer.hint"));
        return hint;
    }

    private JPanel labelled(String key, JTextField field) {
        JLabel label = new JLabel(texts.of(key));
        label.setLabelFor(field);
        ComponentNames.name(field, key, texts.of(key));
        return Arrange.column(2, label, field);
    }

    /** Opens the form with a free name and number, or closes it. */
    void toggle(List<String> names, List<String> numbers) {
        if (isVisible()) {
            close();
            return;
        }
        name.setText(freeName(names));
        number.setText(freeNumber(numbers));
        x.setText("");
        y.setText("");
        heading.setText("");
        problem.show("");
        setVisible(true);
        view.choosePlace(this::placed);
        name.selectAll();
        // laid out first, because the form may have been hidden and cannot take the focus before
        if (SwingUtilities.getRoot(this) instanceof Container window) {
            window.validate();
        }
        scrollRectToVisible(new Rectangle(getWidth(), getHeight()));
        name.requestFocusInWindow();
    }

    private void placed(double xMeters, double yMeters, double headingRadians) {
        x.setText(NumberTexts.fixed(xMeters, 2));
        y.setText(NumberTexts.fixed(yMeters, 2));
        double shown = Double.isNaN(headingRadians) ? 0 : headingRadians;
        heading.setText(NumberTexts.fixed(Math.toDegrees(shown), 0));
        view.placing().show(new RobotPreview(xMeters, yMeters, shown, "", false));
    }

    private void add() {
        try {
            Optional<Pose> place = place();
            addedName = name.getText().strip();
            operator.addRobot(addedName, number.getText().strip(), place, EventThread.onEventThread(this::answered));
        } catch (IllegalArgumentException notANumber) {
            refuse(texts.of("newcomer.numbers", notANumber.getMessage()));
        }
    }

    private void answered(Optional<String> refusal) {
        refuse(refusal.orElse(""));
        if (refusal.isEmpty()) {
            view.requestSelection(addedName);
            close();
        }
    }

    /** Shows the reason and scrolls it and the buttons into view: a low window shows the fields alone. */
    private void refuse(String why) {
        problem.show(why);
        scrollRectToVisible(new Rectangle(0, getHeight() - 1, 1, 1));
    }

    private void close() {
        setVisible(false);
        view.choosePlace(null);
        view.requestFocusInWindow();
    }

    private static String freeName(List<String> taken) {
        int count = taken.size() + 1;
        while (taken.contains("robot" + count)) {
            count++;
        }
        return "robot" + count;
    }

    /** The number after the highest. */
    private static String freeNumber(List<String> taken) {
        return taken.stream()
                .filter(number -> number.matches("[0-9]{1,15}"))
                .map(Long::parseLong)
                .max(Long::compare)
                .map(highest -> String.valueOf(highest + 1))
                .orElse(FIRST_NUMBER);
    }

    /**
     * The typed place in metres and degrees; empty if all fields are; an empty heading is 0.
     *
     * @throws IllegalArgumentException with a text that is not a number
     */
    private Optional<Pose> place() {
        if ((x.getText() + y.getText() + heading.getText()).isBlank()) {
            return Optional.empty();
        }
        return Optional.of(new Pose(number(x), number(y), heading.getText().isBlank() ? 0 : number(heading)));
    }

    /** Parses a decimal with a dot or a comma. */
    private static double number(JTextField field) {
        String word = field.getText().strip();
        String text = word.replace(',', '.');
        if (!text.matches("[-+]?([0-9]{1,7}(\\.[0-9]*)?|\\.[0-9]+)")) {
            throw new IllegalArgumentException(word.isEmpty() ? "\"\"" : word);
        }
        return Double.parseDouble(text);
    }
}
