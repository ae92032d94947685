package simgsm.ui;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import simgsm.draw.Ink;

/** A component that is painted by code and describes its content in words for assistive technology. */
public abstract class PaintedComponent extends JComponent implements Accessible {
    private final transient AccessibleRole role;
    private boolean focusRing;

    /** @param role LABEL for a reading, CANVAS for a picture */
    protected PaintedComponent(AccessibleRole role) {
        this.role = role;
    }

    /** The current content in words. */
    protected abstract String spoken();

    /** Paints the whole component with the rendering hints set; sizes in pixels. */
    protected abstract void paint(Graphics2D g, double width, double height);

    /** Runs a change; if the words change, assistive technology is notified and the component repainted. */
    protected final void change(Runnable change) {
        String before = spoken();
        change.run();
        String after = spoken();
        if (!before.equals(after)) {
            if (accessibleContext != null) {
                accessibleContext.firePropertyChange(AccessibleContext.ACCESSIBLE_NAME_PROPERTY, before, after);
            }
            repaint();
        }
    }

    /** Makes the component focusable; a ring at its edge shows the focus. */
    protected final void makeFocusable() {
        focusRing = true;
        setFocusable(true);
        repaintOnFocus(this);
    }

    /** True if the component takes the focus and shows it. */
    public final boolean showsFocus() {
        return focusRing;
    }

    /** Repaints a component when it gains or loses the focus. */
    public static void repaintOnFocus(JComponent component) {
        component.addFocusListener(new FocusListener() {
            @Override
            public void focusGained(FocusEvent event) {
                component.repaint();
            }

            @Override
            public void focusLost(FocusEvent event) {
                component.repaint();
            }
        });
    }

    /** The preferred size, unless a component can be smaller or has another set. */
    @Override
    public Dimension getMinimumSize() {
        return isMinimumSizeSet() ? super.getMinimumSize() : getPreferredSize();
    }

    @Override
    protected final void paintComponent(Graphics graphics) {
        Graphics2D g = Drawing.on(graphics);
        try {
            paint(g, getWidth(), getHeight());
            if (focusRing && isFocusOwner()) {
                g.setColor(Theme.color(Ink.ACCENT));
                g.setStroke(Theme.line());
                g.draw(Drawing.round(1, 1, getWidth() - 2, getHeight() - 2, Theme.exact(4)));
            }
        } finally {
            g.dispose();
        }
    }

    @Override
    public final AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
                @Override
                public AccessibleRole getAccessibleRole() {
                    return role;
                }

                @Override
                public String getAccessibleName() {
                    return spoken();
                }
            };
        }
        return accessibleContext;
    }
}
