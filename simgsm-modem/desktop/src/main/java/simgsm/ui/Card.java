package simgsm.ui;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.SwingConstants;
import simgsm.draw.Ink;

/** A panel with rounded corners, a thin border, an optional title, and content below it. */
public final class Card extends JPanel {
    private static final double FOLD_UNITS = 14;

    private final Component content;
    /** True if the open card shares the remaining length. */
    private boolean grewOpen;

    private final JLabel title = Theme.label("", Theme::title, Ink.TEXT);

    public Card(Component content) {
        super(new BorderLayout(0, 0));
        this.content = content;
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

    /**
     * Makes the title a button that folds and unfolds the content.
     *
     * @param name of the button, for tests
     */
    public Card folding(String name) {
        JToggleButton fold = new JToggleButton();
        fold.setAction(new UserAction(name, title.getText(), () -> fold(fold)).with(Symbol.DOWN.icon(FOLD_UNITS)));
        ComponentNames.name(fold, name, title.getText());
        fold.setSelected(true);
        Theme.styled(fold, button -> {
            button.setFont(Theme.title());
            button.setForeground(Theme.color(Ink.TEXT));
            button.setHorizontalAlignment(SwingConstants.LEADING);
            button.setHorizontalTextPosition(SwingConstants.LEADING);
            button.setContentAreaFilled(false);
            button.setBorder(Theme.padding(0, 0, Theme.HALF, 0));
        });
        remove(title);
        add(fold, BorderLayout.NORTH);
        return this;
    }

    private void fold(JToggleButton button) {
        boolean open = button.isSelected();
        if (!open) {
            grewOpen = Arrange.grows(this);
        }
        content.setVisible(open);
        button.setIcon((open ? Symbol.DOWN : Symbol.RIGHT).icon(FOLD_UNITS));
        Arrange.setGrowing(this, open && grewOpen);
        revalidate();
    }

    /** The distance of the content from the border, in units; 12 at first. */
    public void setPadding(int units) {
        setBorder(Theme.padding(units));
        revalidate();
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
