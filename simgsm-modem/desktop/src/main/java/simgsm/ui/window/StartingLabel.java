package simgsm.ui.window;

import java.awt.Graphics;
import java.util.Locale;
import javax.swing.JLabel;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Theme;

/** The first content of a window: says that the program starts. It is painted sooner than the program's panel. */
final class StartingLabel extends JLabel {
    private Runnable painted;

    /** @param painted run on the event thread after the first painting */
    StartingLabel(String program, Locale language, Runnable painted) {
        super(DesktopTexts.in(language).of("window.starting", program), SwingConstants.CENTER);
        this.painted = painted;
        setFont(Theme.base());
        setForeground(Theme.color(Ink.TEXT));
        setBackground(Theme.color(Ink.SURFACE));
        setOpaque(true);
        ComponentNames.name(this, "window.starting", getText());
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        if (painted != null) {
            SwingUtilities.invokeLater(painted);
            painted = null;
        }
    }
}
