package simrobot.ui.panel;

import java.awt.event.ActionEvent;
import javax.swing.JComboBox;
import simgsm.console.TextBundle;
import simgsm.ui.ComponentNames;
import simrobot.ui.OperatorActions;

/** The speed of simulated time; a speed from the command line is added to the list. */
final class SpeedChoice {
    private static final double[] SPEEDS = {0.1, 0.25, 0.5, 1, 2, 5, 10, 50, Double.POSITIVE_INFINITY};

    private final TextBundle texts;
    private final OperatorActions operator;
    private final JComboBox<String> box = new JComboBox<>();
    private double shown = 1;
    private boolean showing;

    SpeedChoice(TextBundle texts, OperatorActions operator) {
        this.texts = texts;
        this.operator = operator;
        for (double speed : SPEEDS) {
            box.addItem(word(speed));
        }
        box.setSelectedItem(word(shown));
        box.addActionListener(this::chosen);
        ComponentNames.name(box, "tool.speed", texts.of("tool.speed"));
        box.setToolTipText(texts.of("tool.speed"));
    }

    JComboBox<String> component() {
        return box;
    }

    void show(double speed) {
        if (speed != shown) {
            shown = speed;
            showing = true;
            if (index(speed) < 0) {
                box.addItem(word(speed));
            }
            box.setSelectedItem(word(speed));
            showing = false;
        }
    }

    private void chosen(ActionEvent event) {
        int index = box.getSelectedIndex();
        if (!showing && index >= 0 && index < SPEEDS.length) {
            operator.setSpeed(SPEEDS[index]);
        }
    }

    private static int index(double speed) {
        for (int i = 0; i < SPEEDS.length; i++) {
            if (SPEEDS[i] == speed) {
                return i;
            }
        }
        return -1;
    }

    private String word(double speed) {
        if (Double.isInfinite(speed)) {
            return "\u00d7 " + texts.of("tool.speed.max");
        }
        String number = speed == Math.rint(speed) ? String.valueOf((long) speed) : String.valueOf(speed);
        return "\u00d7 " + number;
    }
}
