package simrobot.ui.panel;

import java.awt.Cursor;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import javax.swing.JComponent;
import simgsm.ui.Theme;

/** The gaps between the parts of a page, which the mouse drags; a double click gives a part its own size again. */
final class PaneDividers extends MouseAdapter {
    /** A part's size, wanted by the user or by itself. */
    static final class Size {
        private final int leastUnits;
        private OptionalInt units = OptionalInt.empty();
        /** Before it was dragged: what a part prefers may follow its present size. */
        private OptionalInt ownUnits = OptionalInt.empty();

        Size(int leastUnits) {
            this.leastUnits = leastUnits;
        }

        /** In pixels. @param own without the user's wish @param most that the page has room for */
        int pixels(int own, int most) {
            return units.isEmpty() ? own : Math.max(Theme.px(leastUnits), Math.min(most, Theme.px(units.getAsInt())));
        }
    }

    /** A gap: dragged to the left, or up, it makes the part behind it larger. */
    private record Divider(Rectangle gap, Size size, int pixels) {
        boolean isUpright() {
            return gap.height > gap.width;
        }
    }

    private final JComponent page;
    private final List<Divider> dividers = new ArrayList<>();
    private Optional<Divider> dragged = Optional.empty();
    private int from;

    PaneDividers(JComponent page) {
        this.page = page;
        page.addMouseListener(this);
        page.addMouseMotionListener(this);
    }

    /** A layout begins. */
    void clear() {
        dividers.clear();
    }

    /** @param pixels the present size of the part at the right of an upright gap, or below another */
    void add(Rectangle gap, Size size, int pixels) {
        dividers.add(new Divider(gap, size, pixels));
    }

    private Optional<Divider> at(MouseEvent event) {
        return dividers.stream()
                .filter(divider -> divider.gap.contains(event.getPoint()))
                .findFirst();
    }

    private static OptionalInt units(int pixels) {
        return OptionalInt.of((int) Math.round(pixels / Theme.zoom()));
    }

    private static int along(Divider divider, MouseEvent event) {
        return divider.isUpright() ? event.getX() : event.getY();
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        page.setCursor(at(event)
                .map(divider -> Cursor.getPredefinedCursor(
                        divider.isUpright() ? Cursor.E_RESIZE_CURSOR : Cursor.N_RESIZE_CURSOR))
                .orElse(null));
    }

    @Override
    public void mousePressed(MouseEvent event) {
        dragged = at(event);
        dragged.ifPresent(divider -> from = along(divider, event));
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        dragged.ifPresent(divider -> {
            int pixels = divider.pixels + from - along(divider, event);
            if (divider.size.ownUnits.isEmpty()) {
                divider.size.ownUnits = units(divider.pixels);
            }
            divider.size.units = units(pixels);
            page.revalidate();
        });
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        dragged = Optional.empty();
    }

    @Override
    public void mouseClicked(MouseEvent event) {
        if (event.getClickCount() == 2) {
            at(event).ifPresent(divider -> {
                divider.size.units = divider.size.ownUnits;
                page.revalidate();
            });
        }
    }
}
