package simrobot.ui.panel;

import java.awt.Container;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import javax.swing.JComponent;
import javax.swing.JPanel;
import simgsm.console.TextBundle;
import simgsm.ui.Arrange.FixedLayout;
import simgsm.ui.Theme;
import simgsm.ui.pane.Divider;
import simrobot.ui.telephone.ModemPanel;
import simrobot.ui.telephone.VeriCommandPanel;

/**
 * The page of a running simulation. Its size determines the layout: in a wide page the column of modem and VeriCommand
 * is at the right of the floor, followed by the inspector; in a narrower one that is high enough, it is below the
 * floor. In a small page the inspector is hidden, and modem and VeriCommand are compact, on the side that leaves the
 * floor the larger area. The floor and the tone scope are always visible. The gaps are dividers.
 */
final class RunningPage extends JPanel {
    /** The smallest page that shows every permanent part, in units. */
    static final Dimension LEAST_UNITS = new Dimension(744, 375);

    private static final int FULL_WIDTH_UNITS = 900;
    private static final int FULL_HEIGHT_UNITS = 640;
    private static final int COLUMN_UNITS = 312;
    /** Minimum width of the floor for the inspector next to the column of modem and VeriCommand. */
    private static final int WIDE_FLOOR_UNITS = 600;

    /** Minimum height of a column that shows modem and VeriCommand in full. */
    private static final int TALL_COLUMN_UNITS = 610;

    private static final int ORDERS_UNITS = 340;
    private static final double ORDERS_SHARE = 0.36;
    /** Width of a panel below which the modem's facts are above the tone scope. */
    private static final int NARROW_MODEM_UNITS = 440;

    /** Minimum size of the floor after a drag. */
    private static final Dimension LEAST_FLOOR_UNITS = new Dimension(240, 160);

    private final JComponent tools;
    private final JComponent notice;
    private final JComponent floor;
    private final JComponent busy;
    private final ModemPanel modem;
    private final VeriCommandPanel orders;
    private final JComponent timeline;
    private final JComponent inspector;
    private final JComponent presentation;
    private final Divider inspectorDivider;
    private final Divider columnDivider;
    private final Divider rowDivider;
    private final Divider ordersDivider;
    private final Divider lowerOrdersDivider;
    private final List<Divider> dividers;
    /** The dividers in a gap of the current layout. */
    private final Set<Divider> placed = new HashSet<>();

    private boolean hasLine;
    private boolean isPresenting;
    private boolean isInspectorWanted;
    private boolean isInspectorSwitched;
    private boolean atRight;

    RunningPage(
            TextBundle texts,
            JComponent tools,
            JComponent notice,
            JComponent floor,
            JComponent busy,
            ModemPanel modem,
            VeriCommandPanel orders,
            JComponent timeline,
            JComponent inspector,
            JComponent presentation) {
        this.tools = tools;
        this.notice = notice;
        this.floor = floor;
        this.busy = busy;
        this.modem = modem;
        this.orders = orders;
        this.timeline = timeline;
        this.inspector = inspector;
        this.presentation = presentation;
        setOpaque(false);
        for (JComponent part :
                new JComponent[] {tools, notice, floor, busy, modem, orders, timeline, inspector, presentation}) {
            add(part);
        }
        inspectorDivider = divider(texts, "divider.inspector", 200);
        columnDivider = divider(texts, "divider.column", COLUMN_UNITS - 40);
        rowDivider = divider(texts, "divider.row", ModemPanel.COMPACT_HEIGHT_UNITS);
        ordersDivider = divider(texts, "divider.orders", 180);
        lowerOrdersDivider = divider(texts, "divider.orders.lower", 90);
        dividers = List.of(inspectorDivider, columnDivider, rowDivider, ordersDivider, lowerOrdersDivider);
        dividers.forEach(this::add);
        presentation.setVisible(false);
        setLayout(new Parts());
    }

    private static Divider divider(TextBundle texts, String id, int leastUnits) {
        Locale language = Locale.forLanguageTag(texts.of("language.tag"));
        return new Divider(id, texts.of(id), language, leastUnits);
    }

    /** @param present true if the selected robot has a modem; otherwise modem and VeriCommand are hidden */
    void setLinePresent(boolean present) {
        if (hasLine != present) {
            hasLine = present;
            revalidate();
        }
    }

    /** Presents: the floor fills the page above one large line of text. */
    void setPresenting(boolean presenting) {
        isPresenting = presenting;
        tools.setVisible(!presenting);
        presentation.setVisible(presenting);
        revalidate();
    }

    boolean isPresenting() {
        return isPresenting;
    }

    /** Shows the inspector if the size hides it, or hides it. */
    void switchInspector() {
        isInspectorWanted = !inspector.isVisible();
        isInspectorSwitched = true;
        revalidate();
    }

    @Override
    public void doLayout() {
        boolean wide = isWide();
        boolean full = !wide && isFull();
        atRight = wide || !full && isColumnBetter(restOfPage());
        inspector.setVisible(!isPresenting && (isInspectorSwitched ? isInspectorWanted : full || wide));
        boolean replaced = inspector.isVisible() && !full && !wide;
        modem.setVisible(hasLine && !isPresenting && !replaced);
        orders.setVisible(modem.isVisible());
        boolean whole = full || atRight && restOfPage().height >= Theme.px(TALL_COLUMN_UNITS);
        modem.arrange(!whole, atRight || modemWidthInRow(getWidth() - inspectorWidth()) < Theme.px(NARROW_MODEM_UNITS));
        orders.setCompact(!whole);
        super.doLayout();
    }

    private int inspectorWidth() {
        return inspector.isVisible() ? inspector.getPreferredSize().width + gap() : 0;
    }

    /** The modem's width in a row shared with VeriCommand. */
    private static int modemWidthInRow(int rowWidth) {
        return rowWidth - gap() - Math.min(Theme.px(ORDERS_UNITS), (int) (rowWidth * ORDERS_SHARE));
    }

    private boolean isFull() {
        return getWidth() >= Theme.px(FULL_WIDTH_UNITS) && getHeight() >= Theme.px(FULL_HEIGHT_UNITS);
    }

    private boolean isWide() {
        int beside = columnWidth() + gap() + inspector.getPreferredSize().width;
        return getWidth() - beside >= Theme.px(WIDE_FLOOR_UNITS);
    }

    /** The page below tools and notice. */
    private Rectangle restOfPage() {
        int top = 0;
        if (tools.isVisible()) {
            tools.setSize(getWidth(), tools.getHeight());
            top += tools.getPreferredSize().height + gap();
        }
        if (notice.isVisible()) {
            top += notice.getPreferredSize().height + gap();
        }
        return new Rectangle(0, top, getWidth(), Math.max(0, getHeight() - top));
    }

    private boolean isColumnBetter(Rectangle rest) {
        long atRight = (long) (rest.width - columnWidth()) * rest.height;
        long below = (long) rest.width * (rest.height - Theme.px(ModemPanel.COMPACT_HEIGHT_UNITS) - gap());
        return atRight > below;
    }

    private static int columnWidth() {
        return Theme.px(COLUMN_UNITS) + gap();
    }

    private static int gap() {
        return Theme.px(Theme.GRID);
    }

    private final class Parts implements FixedLayout {
        @Override
        public Dimension preferredLayoutSize(Container parent) {
            return minimumLayoutSize(parent);
        }

        @Override
        public Dimension minimumLayoutSize(Container parent) {
            return new Dimension(Theme.px(LEAST_UNITS.width), Theme.px(LEAST_UNITS.height));
        }

        @Override
        public void layoutContainer(Container parent) {
            placed.clear();
            Rectangle rest = restOfPage();
            int top = 0;
            if (tools.isVisible()) {
                tools.setBounds(0, 0, getWidth(), tools.getPreferredSize().height);
                top = tools.getHeight() + gap();
            }
            if (notice.isVisible()) {
                notice.setBounds(0, top, getWidth(), notice.getPreferredSize().height);
            }
            if (inspector.isVisible()) {
                inspector.setBounds(cutRight(rest, inspectorDivider, inspector.getPreferredSize().width));
            }
            if (modem.isVisible() && atRight) {
                stackAtRight(rest);
            }
            takeBottom(rest, presentation);
            takeBottom(rest, timeline);
            if (modem.isVisible() && !atRight) {
                rowAtBottom(rest);
            }
            takeBottom(rest, busy);
            floor.setBounds(rest);
            for (Divider divider : dividers) {
                if (divider.isVisible() != placed.contains(divider)) {
                    divider.setVisible(placed.contains(divider));
                }
            }
        }

        private void place(Divider divider, int x, int y, int width, int height) {
            placed.add(divider);
            divider.place(x, y, width, height);
        }

        /** Gives VeriCommand its height and the tone scope the rest, at least its minimum. */
        private void stackAtRight(Rectangle rest) {
            Rectangle column = cutRight(rest, columnDivider, Theme.px(COLUMN_UNITS));
            int spare = column.height - gap() - modem.getPreferredSize().height;
            int own = Math.min(orders.getPreferredSize().height, Math.max(spare, orders.getMinimumSize().height));
            int ordersHeight = lowerOrdersDivider.sized(Math.min(column.height / 2, own), column.height / 2);
            place(lowerOrdersDivider, column.x, column.y + column.height - ordersHeight - gap(), column.width, gap());
            int modemHeight = column.height - gap() - ordersHeight;
            modem.setBounds(column.x, column.y, column.width, Math.max(0, modemHeight));
            orders.setBounds(column.x, column.y + modemHeight + gap(), column.width, ordersHeight);
        }

        private void rowAtBottom(Rectangle rest) {
            int own = Math.max(modem.getPreferredSize().height, orders.getPreferredSize().height);
            int height = rowDivider.sized(own, rest.height - gap() - Theme.px(LEAST_FLOOR_UNITS.height));
            Rectangle row = cutBottom(rest, height);
            place(rowDivider, row.x, row.y - gap(), row.width, gap());
            int ordersWidth = ordersDivider.sized(row.width - gap() - modemWidthInRow(row.width), row.width / 2);
            int modemWidth = row.width - gap() - ordersWidth;
            place(ordersDivider, row.x + modemWidth, row.y, gap(), row.height);
            modem.setBounds(row.x, row.y, modemWidth, row.height);
            orders.setBounds(row.x + modemWidth + gap(), row.y, ordersWidth, row.height);
        }

        private void takeBottom(Rectangle rest, JComponent part) {
            if (part.isVisible()) {
                part.setBounds(cutBottom(rest, part.getPreferredSize().height));
            }
        }

        private Rectangle cutRight(Rectangle rest, Divider divider, int own) {
            int width = divider.sized(own, rest.width - gap() - Theme.px(LEAST_FLOOR_UNITS.width));
            rest.width = Math.max(0, rest.width - width - gap());
            place(divider, rest.x + rest.width, rest.y, gap(), rest.height);
            return new Rectangle(rest.x + rest.width + gap(), rest.y, width, rest.height);
        }

        private Rectangle cutBottom(Rectangle rest, int height) {
            rest.height = Math.max(0, rest.height - height - gap());
            return new Rectangle(rest.x, rest.y + rest.height + gap(), rest.width, height);
        }
    }
}
