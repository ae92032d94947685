package simgsm.ui;

import javax.swing.JComponent;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.synth.SynthToolTipUI;

/** Tool tips that show every text literally and load no picture, as {@link PlainLabelUI} does. */
public final class PlainToolTipUI extends SynthToolTipUI {
    private PlainToolTipUI() {}

    /** Called by Swing for each tool tip. */
    public static ComponentUI createUI(JComponent tip) {
        return new PlainToolTipUI();
    }

    @Override
    public void installUI(JComponent tip) {
        tip.putClientProperty("html.disable", true);
        super.installUI(tip);
    }
}
