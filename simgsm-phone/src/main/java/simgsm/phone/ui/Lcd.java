package simgsm.phone.ui;

import java.awt.Graphics2D;
import java.time.Clock;
import java.time.LocalTime;
import java.time.ZonedDateTime;
import java.util.Locale;
import javax.accessibility.AccessibleRole;
import simgsm.console.TextBundle;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.ui.PaintedComponent;

/** The phone's display. */
final class Lcd extends PaintedComponent {
    private final LcdPainter painter;
    private final LcdSpoken spoken;
    private final Clock clock;
    private HandsetSnapshot phone;
    private int shownMinute = -1;

    Lcd(TextBundle texts, Locale language, Clock clock, HandsetSnapshot first) {
        super(AccessibleRole.LABEL);
        this.spoken = new LcdSpoken(texts, new WordsText(texts, clock.getZone()));
        this.painter = new LcdPainter(texts, language, clock.getZone());
        this.clock = clock;
        this.phone = first;
        setName("lcd");
        makeFocusable();
    }

    void show(HandsetSnapshot snapshot) {
        boolean sameLook = snapshot.screen().equals(phone.screen())
                && snapshot.call().equals(phone.call())
                && snapshot.typed().equals(phone.typed())
                && snapshot.caret() == phone.caret()
                && snapshot.softKeys().equals(phone.softKeys())
                && snapshot.names() == phone.names()
                && snapshot.missed() == phone.missed()
                && snapshot.clock().equals(phone.clock())
                && snapshot.station().equals(phone.station())
                && snapshot.folders().equals(phone.folders());
        change(() -> phone = snapshot);
        if (!sameLook) {
            repaint();
        }
    }

    /** Repaints when the minute has changed. */
    void lookAtClock() {
        if (time().getMinute() != shownMinute) {
            repaint();
        }
    }

    private LocalTime time() {
        return phone.clock().at(ZonedDateTime.now(clock)).toLocalTime();
    }

    @Override
    protected String spoken() {
        return spoken.of(phone);
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        LocalTime now = time();
        shownMinute = now.getMinute();
        painter.paint(g, phone, now, getWidth(), getHeight());
    }
}
