package blackbox.face;

import static org.junit.jupiter.api.Assertions.assertEquals;

import blackbox.face.PaintedTexts.Painted;
import blackbox.face.SuiteWindows.Which;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import javax.accessibility.AccessibleRole;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.draw.Appearance;
import simgsm.ui.ComponentNames;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;
import simgsm.ui.window.SuiteWindow;

/**
 * Every window in both languages, at its least size, at those of the demo and at large ones, at several zooms: no text is cut,
 * clipped or lies over another. {@code -Dface.all=true} takes every size with every zoom, language and theme; otherwise
 * each occurs, but not all together.
 */
@ResourceLock("the theme, which is one for the process")
class FaceTest {
    private static final double[] ZOOMS = {1, 1.5, 2};
    private static final boolean ALL = Boolean.getBoolean("face.all");
    /** Boxes of texts may touch by as much, in pixels. */
    private static final double TOUCH = 2;

    private int sampled;
    private final SuiteWindows windows = new SuiteWindows();

    @AfterEach
    void lightAgain() {
        Theme.install(Appearance.LIGHT);
        Theme.zoomTo(1);
    }

    /** Widths and heights in units. */
    private static List<Dimension> sizes(Which which) {
        return switch (which) {
            case PHONE -> List.of(SuiteWindow.PHONE.least(), new Dimension(320, 1000), new Dimension(480, 980));
            case REPLAY -> List.of(SuiteWindow.ROBOT.least(), new Dimension(1120, 800));
            case ROBOT ->
                List.of(
                        SuiteWindow.ROBOT.least(),
                        new Dimension(940, 500),
                        new Dimension(1228, 615),
                        new Dimension(1120, 800),
                        new Dimension(1900, 1000));
            case CENTER ->
                List.of(
                        SuiteWindow.CENTER.least(),
                        new Dimension(940, 330),
                        new Dimension(1228, 355),
                        new Dimension(1160, 700),
                        new Dimension(1900, 1000));
            case TOWN -> List.of(SuiteWindow.CELLS.least(), new Dimension(1100, 760), new Dimension(1900, 1000));
            case CLASS -> List.of(new Dimension(430, 740), new Dimension(900, 700));
            case SCOPE -> List.of(new Dimension(320, 420), new Dimension(694, 536), new Dimension(1300, 900));
            case LESSONS -> List.of(new Dimension(420, 400), new Dimension(760, 600));
            case LESSON -> List.of(new Dimension(270, 740), new Dimension(460, 1000));
            case SHEET -> List.of(new Dimension(420, 400), new Dimension(760, 600));
        };
    }

    @ParameterizedTest
    @EnumSource
    void noTextIsCutOrCovered(Which which) throws Exception {
        Set<String> faults = new TreeSet<>();
        SwingUtilities.invokeAndWait(() -> {
            int turn = 0;
            for (Dimension size : sizes(which)) {
                for (double zoom : ZOOMS) {
                    for (String language : List.of("en", "es")) {
                        for (Appearance theme : Appearance.values()) {
                            boolean isSample = turn++ % 7 == 0;
                            boolean isUsual = zoom == 1 && theme == Appearance.LIGHT;
                            boolean hasManyForms = which == Which.ROBOT
                                    || which == Which.REPLAY
                                    || which == Which.LESSON
                                    || which == Which.SHEET;
                            if (ALL || isSample || isUsual) {
                                faults.addAll(
                                        faults(which, size, zoom, language, theme, ALL || isUsual || !hasManyForms));
                            }
                        }
                    }
                }
            }
        });
        assertEquals("", String.join("\n", faults));
    }

    /** @param all takes every form, else one, in turn */
    private Set<String> faults(
            Which which, Dimension size, double zoom, String language, Appearance theme, boolean all) {
        Theme.install(theme);
        Theme.zoomTo(zoom);
        Set<String> faults = new LinkedHashSet<>();
        List<String> forms = SuiteWindows.forms(which);
        for (String form : all ? forms : List.of(forms.get(sampled++ % forms.size()))) {
            JComponent window = windows.open(which, language, form);
            SuiteWindows.layOut(window, (int) (size.width * zoom), (int) (size.height * zoom));
            SuiteWindows.take(window, form);
            SuiteWindows.layOut(window, (int) (size.width * zoom), (int) (size.height * zoom));
            String where = which + " " + form + " " + size.width + "x" + size.height + " at " + zoom + " " + language;
            List<Found> found = new ArrayList<>();
            collect(window, window, found);
            for (Found text : found) {
                text.fault().ifPresent(what -> faults.add(where + ": " + what));
            }
            faults.addAll(covered(where, found));
            tabRuns(window).forEach(fault -> faults.add(where + ": " + fault));
            outside(window, window).forEach(fault -> faults.add(where + ": " + fault));
        }
        return faults;
    }

    /** Faults of buttons: an edge lies outside the container or the window. */
    private static List<String> outside(JComponent window, Component component) {
        List<String> faults = new ArrayList<>();
        if (!component.isVisible()) {
            return faults;
        }
        if (component instanceof AbstractButton button && !SuiteWindows.isScrolled(button) && button.getWidth() > 0) {
            Rectangle seen = visible(button, window);
            if (seen.width < button.getWidth() || seen.height < button.getHeight()) {
                faults.add("outside: " + button.getName());
            }
        }
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) {
                faults.addAll(outside(window, child));
            }
        }
        return faults;
    }

    private static List<String> tabRuns(Component component) {
        List<String> faults = new ArrayList<>();
        if (!component.isVisible()) {
            return faults;
        }
        if (component instanceof JTabbedPane tabs && tabs.getTabCount() > 0) {
            Rectangle first = tabs.getBoundsAt(0);
            Rectangle last = tabs.getBoundsAt(tabs.getTabCount() - 1);
            if (first != null && last != null && first.y != last.y) {
                faults.add("tabs in two rows");
            }
        }
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) {
                faults.addAll(tabRuns(child));
            }
        }
        return faults;
    }

    /** A text in a component, in the window's coordinates. */
    private record Found(Component component, Painted text, boolean isScrolled) {
        private static final Set<String> MAY_BE_CUT = Set.of("world", "map");

        private String name() {
            String name = component.getName();
            return name == null ? component.getClass().getSimpleName() : name;
        }

        Optional<String> fault() {
            if (MAY_BE_CUT.contains(name())) {
                return Optional.empty();
            }
            Rectangle2D box = text.box();
            Rectangle2D clip = text.clip();
            String what = name() + " \"" + text.text() + "\"";
            boolean hasToolTip = component instanceof JComponent it && it.getToolTipText() != null;
            // What a button does must be read without the mouse, which no class has.
            boolean isButton = component instanceof AbstractButton button
                    && !text.text().equals(button.getText()); // such as "Save as ..."
            boolean isCell = component instanceof JTable;
            if (text.text().matches("[0-9 ]+\u2026")) {
                return Optional.of("a number cut behind: " + what);
            }
            boolean isCut = (text.text().endsWith("\u2026") || text.text().endsWith("..."))
                    && !(component instanceof JTextComponent); // which cuts nothing, but may tell of more
            if (isCut && !isCell && (!hasToolTip || isButton)) {
                return Optional.of("cut: " + what);
            }
            if (!clip.intersects(box) || isScrolled && (box.getY() < clip.getY() || box.getMaxY() > clip.getMaxY())) {
                return Optional.empty();
            }
            boolean isInside = box.getX() >= clip.getX() - TOUCH
                    && box.getMaxX() <= clip.getMaxX() + TOUCH
                    && box.getY() >= clip.getY() - 1
                    && box.getMaxY() <= clip.getMaxY() + 1;
            return isInside ? Optional.empty() : Optional.of("clipped: " + what);
        }
    }

    private static List<String> covered(String where, List<Found> found) {
        List<String> faults = new ArrayList<>();
        for (int i = 0; i < found.size(); i++) {
            for (int j = i + 1; j < found.size(); j++) {
                Found one = found.get(i);
                Found other = found.get(j);
                Rectangle2D common = one.text()
                        .box()
                        .createIntersection(one.text().clip())
                        .createIntersection(other.text()
                                .box()
                                .createIntersection(other.text().clip()));
                boolean isMap = one.name().equals(other.name()) && Found.MAY_BE_CUT.contains(one.name());
                if (!isMap && common.getWidth() > TOUCH && common.getHeight() > TOUCH) {
                    faults.add(where + ": " + one.name() + " \"" + one.text().text() + "\" over " + other.name() + " \""
                            + other.text().text() + "\"");
                }
            }
        }
        return faults;
    }

    /** The texts of the components without children, and of those that paint their cells themselves. */
    private static void collect(JComponent window, Component component, List<Found> found) {
        if (!component.isVisible()) {
            return;
        }
        boolean paintsAll = component instanceof JTable || component instanceof JList || component instanceof JComboBox;
        if (component instanceof Container container && container.getComponentCount() > 0 && !paintsAll) {
            for (Component child : container.getComponents()) {
                collect(window, child, found);
            }
        } else if (component instanceof JComponent leaf && component.getWidth() > 0 && component.getHeight() > 0) {
            PaintedTexts graphics = new PaintedTexts(window.getWidth(), window.getHeight());
            Rectangle place = SwingUtilities.convertRectangle(leaf.getParent(), leaf.getBounds(), window);
            Rectangle seen = visible(leaf, window);
            if (!seen.isEmpty()) {
                graphics.clipRect(seen.x, seen.y, seen.width, seen.height);
                graphics.translate(place.x, place.y);
                leaf.print(graphics);
                graphics.texts().forEach(text -> found.add(new Found(leaf, text, SuiteWindows.isScrolled(leaf))));
            }
        }
    }

    private static Rectangle visible(JComponent leaf, JComponent window) {
        Rectangle seen = new Rectangle(0, 0, leaf.getWidth(), leaf.getHeight());
        Component at = leaf;
        while (at != window) {
            seen.translate(at.getX(), at.getY());
            at = at.getParent();
            seen = seen.intersection(new Rectangle(0, 0, at.getWidth(), at.getHeight()));
        }
        return seen;
    }

    @ParameterizedTest
    @EnumSource
    void everyControlIsNamedInBothLanguages(Which which) throws Exception {
        List<String> nameless = new ArrayList<>();
        SwingUtilities.invokeAndWait(() -> {
            for (String language : List.of("en", "es")) {
                for (Component component : ComponentNames.unnamed(windows.open(which, language))) {
                    nameless.add(language + " " + component.getName() + " "
                            + component.getClass().getSimpleName());
                }
            }
        });
        assertEquals(List.of(), nameless);
    }

    @ParameterizedTest
    @EnumSource
    void everyPictureAndEveryScrolledPartIsReachedByTheKeyboard(Which which) throws Exception {
        List<String> unreached = new ArrayList<>();
        SwingUtilities.invokeAndWait(() -> {
            JComponent window = windows.open(which, "en");
            unreached.addAll(unreached(window));
        });
        assertEquals(List.of(), unreached);
    }

    /** Pictures that take no focus, and scroll panes in which, and at which, nothing takes the focus. */
    private static List<String> unreached(Component component) {
        List<String> found = new ArrayList<>();
        boolean isPicture = component instanceof PaintedComponent painted
                && painted.getAccessibleContext().getAccessibleRole() == AccessibleRole.CANVAS;
        if (isPicture && !takesFocus(component) || component instanceof JScrollPane pane && !reaches(pane)) {
            found.add(component.getName() + " " + component.getClass().getSimpleName());
        }
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) {
                found.addAll(unreached(child));
            }
        }
        return found;
    }

    private static boolean reaches(JScrollPane pane) {
        return takesFocus(pane) || inside(pane.getViewport()).anyMatch(FaceTest::takesFocus);
    }

    private static Stream<Component> inside(Container container) {
        return Stream.of(container.getComponents())
                .flatMap(child -> child instanceof Container inner
                        ? Stream.concat(Stream.of(child), inside(inner))
                        : Stream.of(child));
    }

    /** Panels and labels are focusable by default, but have no keys. */
    private static boolean takesFocus(Component component) {
        return component.isFocusable()
                && component instanceof JComponent it
                && (it.getInputMap(JComponent.WHEN_FOCUSED).allKeys() != null
                        || it.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                                        .allKeys()
                                != null
                        || it instanceof PaintedComponent painted && painted.showsFocus());
    }
}
