package simgsm.ui;

import java.awt.BorderLayout;
import javax.swing.JPanel;

/** A panel with a border layout that sets fonts, colours and sizes of the theme again after each change of the look. */
public abstract class DressedPanel extends JPanel {
    protected DressedPanel() {
        super(new BorderLayout());
    }

    /** Sets the properties that depend on the theme. A constructor calls it once all components are added. */
    protected abstract void dress();

    @Override
    public void updateUI() {
        super.updateUI();
        // The constructor of JPanel calls this method before there are components.
        if (getComponentCount() > 0) {
            dress();
        }
    }
}
