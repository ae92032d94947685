package simgsm.ui.scope;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.dtmf.DtmfKey;
import simgsm.scope.KeyPrediction;
import simgsm.scope.KeyPrediction.Stage;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/** Asks for the key that a student reads off the picture, and marks the answer as right or wrong. */
final class PredictionBar extends JPanel {
    private final TextBundle texts;
    private final KeyPrediction prediction;
    private final JLabel question = Theme.label(" ", Theme::base, Ink.TEXT);
    private final JTextField field = new JTextField(2);
    /** Tells which window gets the typed keys, and how to change that. */
    private final JLabel keyboard = Theme.label(" ", Theme::small, Ink.TEXT);

    /** @param guess receives each typed key; @param practise plays a tone to guess */
    PredictionBar(TextBundle texts, KeyPrediction prediction, Consumer<DtmfKey> guess, Runnable practise) {
        super(new BorderLayout());
        this.texts = texts;
        this.prediction = prediction;
        setOpaque(false);
        ComponentNames.name(question, "scope.question", "");
        ComponentNames.name(field, "scope.guess", texts.of("scope.guess"));
        field.setToolTipText(texts.of("scope.guess.tip"));
        field.addKeyListener(new KeyAdapter() {
            @Override
            public void keyTyped(KeyEvent event) {
                key(event.getKeyChar(), guess);
                event.consume();
            }
        });
        field.addFocusListener(new FocusListener() {
            @Override
            public void focusGained(FocusEvent event) {
                tellKeyboard(true);
            }

            @Override
            public void focusLost(FocusEvent event) {
                tellKeyboard(false);
            }
        });
        ComponentNames.name(keyboard, "scope.keyboard", "");
        tellKeyboard(false);
        field.addActionListener(event -> practise.run());
        Theme.styled(field, it -> {
            it.setFont(Theme.monoStrong());
            it.setHorizontalAlignment(JTextField.CENTER);
        });
        JLabel answer = Theme.label(texts.of("scope.guess"), Theme::small, Ink.QUIET);
        answer.setLabelFor(field);
        add(Arrange.column(
                2, question, Arrange.row(6, answer, field, Arrange.spring(), practiseButton(practise)), keyboard));
        Theme.styled(this, panel -> panel.setBorder(Theme.padding(4, 0, 0, 0)));
        update();
    }

    private JButton practiseButton(Runnable practise) {
        JButton tone = new JButton(new UserAction("scope.practise", texts.of("scope.practise"), practise)
                .described(texts.of("scope.practise.tip"))
                .with(Symbol.PLAY.icon(14)));
        ComponentNames.name(tone, "scope.practise", texts.of("scope.practise"));
        Theme.styled(tone, it -> {
            it.setFont(Theme.small());
            it.setBorder(Theme.padding(4, 4, 4, 6));
        });
        return tone;
    }

    private void tellKeyboard(boolean isHere) {
        String words = texts.of(isHere ? "scope.keyboard.here" : "scope.keyboard.elsewhere");
        keyboard.setText(words);
        keyboard.getAccessibleContext().setAccessibleName(words);
        field.getAccessibleContext().setAccessibleDescription(words);
    }

    private void key(char typed, Consumer<DtmfKey> guess) {
        char symbol = Character.toUpperCase(typed);
        for (DtmfKey key : DtmfKey.values()) {
            if (key.symbol() == symbol) {
                field.setText(String.valueOf(symbol));
                guess.accept(key);
            }
        }
    }

    /** Shows the stage: the question, or the answer with its two frequencies. */
    void update() {
        Stage stage = prediction.stage();
        if (stage == Stage.ASKING) {
            field.setText("");
        }
        String score = texts.of("scope.score", prediction.right(), prediction.asked());
        String words = texts.of(
                "scope.stage." + stage.name(),
                prediction.answer().map(this::key).orElse(""),
                score);
        question.setText(words);
        question.setToolTipText(words);
        question.getAccessibleContext().setAccessibleName(words);
        question.setForeground(
                Theme.color(stage == Stage.RIGHT ? Ink.GOOD : stage == Stage.WRONG ? Ink.DANGER : Ink.TEXT));
    }

    private String key(DtmfKey key) {
        return texts.of(
                "scope.key", String.valueOf(key.symbol()), String.valueOf((int) key.rowHertz()), String.valueOf((int)
                        key.columnHertz()));
    }

    void focusField() {
        field.requestFocusInWindow();
    }

    boolean hasFocus(Component owner) {
        return owner != null && SwingUtilities.isDescendingFrom(owner, this);
    }
}
