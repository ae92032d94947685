package simgsm.ui;

import javax.swing.JComponent;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.synth.SynthLabelUI;

/**
 * Labels, and the cells of lists and tables, which are labels, that show every text literally and load no picture: Swing
 * reads a text that begins with {@code <html>} as markup, and names and messages come from outside.
 */
public final class PlainLabelUI extends SynthLabelUI {
    private PlainLabelUI() {}

    /** Called by Swing for each label. */
    public static ComponentUI createUI(JComponent label) {
        return new PlainLabelUI();
    }

    @Override
    public void installUI(JComponent label) {
        label.putClientProperty("html.disable", true);
        super.installUI(label);
    }
}
