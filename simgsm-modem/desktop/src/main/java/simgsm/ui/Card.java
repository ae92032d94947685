package simgsm.ui;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.swing.JLabel;
import javax.swing.JPanel;
import simgsm.draw.Ink;

/** A panel with rounded corners, a thin border, an optional title, and content below it. */
public final class Card extends JPanel {
    private final JLabel title = Theme.label("", Theme::title, Ink.TEXT);

    public Card(Component content) {
        super(new BorderLayout(0, 0));
        setOpaque(false);
        setBorder(Theme.padding(12));
        add(content, BorderLayout.CENTER);
    }

    public Card(String titleText, Component content) {
        this(content);
        title.setText(titleText);
        title.setBorder(Theme.padding(0, 0, Theme.GRID, 0));
        add(title, BorderLayout.NORTH);
    }

    /** Shows the title, or gives its height to the content. */
    public void setTitleVisible(boolean visible) {
        title.setVisible(visible);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Drawing.on(graphics);
        try {
            var sheet = Drawing.round(0.5, 0.5, getWidth() - 1, getHeight() - 1, Theme.exact(Theme.CARD_RADIUS));
            g.setColor(Theme.color(Ink.CARD));
            g.fill(sheet);
            g.setColor(Theme.color(Ink.LINE));
            g.setStroke(Theme.hairline());
            g.draw(sheet);
        } finally {
            g.dispose();
        }
    }
}
