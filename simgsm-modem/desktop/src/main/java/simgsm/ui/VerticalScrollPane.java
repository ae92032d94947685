package simgsm.ui;

import java.awt.Component;
import javax.swing.JScrollPane;

/** A scroll pane that scrolls only up and down. */
public class VerticalScrollPane extends JScrollPane {
    public VerticalScrollPane(Component view) {
        super(view, VERTICAL_SCROLLBAR_AS_NEEDED, HORIZONTAL_SCROLLBAR_NEVER);
    }

    /** Takes away the border, in every appearance, and shows what is behind. @return the same */
    public VerticalScrollPane bare() {
        setOpaque(false);
        getViewport().setOpaque(false);
        return Theme.styled(this, pane -> {
            pane.setBorder(null);
            pane.setViewportBorder(null);
        });
    }
}
