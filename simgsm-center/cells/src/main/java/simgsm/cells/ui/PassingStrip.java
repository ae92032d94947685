package simgsm.cells.ui;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.accessibility.AccessibleRole;
import simgsm.cells.snapshot.PassingStep;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;

/** The signalling between the selected mobile, its towers and the controller, newest at the right. */
final class PassingStrip extends PaintedComponent {
    private static final int HEIGHT_UNITS = 30;

    /** Number of reports of a sequence shown separately; the earlier ones share a box. */
    private static final int REPORTS_EACH = 3;

    /** A box of the strip. */
    private record Box(PassingStep.Kind kind, String words) {}

    private final TextBundle texts;
    private transient List<PassingStep> shown = List.of();

    PassingStrip(TextBundle texts) {
        super(AccessibleRole.LABEL);
        this.texts = texts;
        setName("strip");
        setToolTipText(texts.of("strip.why"));
    }

    /** @param selected the mobile whose steps are shown with those of the towers; empty for all */
    void show(List<PassingStep> passing, Optional<String> selected) {
        List<PassingStep> filtered = passing.stream()
                .filter(step -> selected.isEmpty()
                        || step.number().isEmpty()
                        || step.number().equals(selected.get()))
                .toList();
        if (!filtered.equals(shown)) {
            change(() -> shown = filtered);
            repaint();
        }
    }

    /** One step in words, such as "report 17" or "Handover Command B". */
    static String words(TextBundle texts, PassingStep step) {
        return texts.of(
                "passing." + step.kind().name().toLowerCase(Locale.ROOT),
                String.valueOf(step.figure()),
                step.from(),
                step.to());
    }

    /** The words of the boxes, newest last. */
    List<String> words() {
        return boxes().stream().map(Box::words).toList();
    }

    private List<Box> boxes() {
        List<Box> boxes = new ArrayList<>();
        int at = 0;
        while (at < shown.size()) {
            int end = at;
            while (end < shown.size() && shown.get(end).kind() == PassingStep.Kind.REPORT) {
                end++;
            }
            if (end - at > REPORTS_EACH + 1) {
                int last = end - REPORTS_EACH - 1;
                boxes.add(new Box(
                        PassingStep.Kind.REPORT,
                        texts.of(
                                "passing.reports",
                                String.valueOf(shown.get(at).figure()),
                                String.valueOf(shown.get(last).figure()))));
                at = last + 1;
            } else {
                boxes.add(new Box(shown.get(at).kind(), words(texts, shown.get(at))));
                at++;
            }
        }
        return boxes;
    }

    private static Ink ink(PassingStep.Kind kind) {
        return switch (kind) {
            case HANDOVER_COMMAND, HANDOVER_ACCESS, PHYSICAL_INFORMATION, ASSIGNMENT_COMMAND -> Ink.ACCENT;
            case HANDOVER_COMPLETE, ASSIGNMENT_COMPLETE, LOCATION_UPDATE, CIPHERING, TOWER_ON -> Ink.GOOD;
            case HANDOVER_FAILURE, RADIO_LINK_FAILURE, TOWER_OFF, TOWER_REFUSED -> Ink.DANGER;
            case SPEECH_GAP -> Ink.WARNING;
            default -> Ink.CONTROL_LINE;
        };
    }

    @Override
    protected String spoken() {
        return shown.isEmpty() ? texts.of("strip.none") : words(texts, shown.get(shown.size() - 1));
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Theme.px(400), Theme.px(HEIGHT_UNITS));
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Theme.px(200), Theme.px(HEIGHT_UNITS));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        double right = width;
        double tall = Theme.exact(24);
        double top = (height - tall) / 2;
        if (shown.isEmpty()) {
            g.setFont(Theme.base());
            g.setColor(Theme.color(Ink.QUIET));
            g.drawString(texts.of("strip.none"), 0, (float) (height / 2 + Drawing.capHeight(g, Theme.base()) / 2));
        }
        List<Box> boxes = boxes();
        for (int i = boxes.size() - 1; i >= 0 && right > 0; i--) {
            String words = boxes.get(i).words();
            Ink ink = ink(boxes.get(i).kind());
            boolean isPlain = ink == Ink.CONTROL_LINE;
            var font = isPlain ? Theme.small() : Theme.strong();
            double wide = Drawing.width(font, words) + Theme.exact(16);
            double left = right - wide;
            if (left < 0 && i < boxes.size() - 1) {
                return; // only whole boxes, but at least the newest
            }
            var box = Drawing.round(left + 0.5, top + 0.5, wide - 1, tall - 1, Theme.exact(Theme.CONTROL_RADIUS));
            g.setColor(Theme.color(isPlain ? Ink.CARD : ink));
            g.fill(box);
            g.setColor(Theme.color(ink));
            g.setStroke(Theme.hairline());
            g.draw(box);
            g.setColor(Theme.color(isPlain ? Ink.TEXT : Ink.ON_SIGNAL));
            Drawing.centred(g, words, font, left + wide / 2, height / 2);
            right = left - Theme.exact(6);
        }
    }
}
