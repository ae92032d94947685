package simgsm.phone.ui;

import java.awt.Graphics;
import java.awt.Graphics2D;
import java.time.Clock;
import java.time.LocalTime;
import java.util.Locale;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import simgsm.phone.handset.CallPhase;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.handset.Screen;
import simgsm.phone.handset.ToneMeaning;
import simgsm.ui.Drawing;
import simgsm.ui.Texts;

/** The phone's display. */
final class Lcd extends JComponent {
    private final Texts texts;
    private final LcdPainter painter;
    private final Clock clock;
    private HandsetSnapshot phone;
    private int shownMinute = -1;

    Lcd(Texts texts, Clock clock, HandsetSnapshot first) {
        this.texts = texts;
        this.painter = new LcdPainter(texts, clock.getZone());
        this.clock = clock;
        this.phone = first;
        setName("lcd");
    }

    void show(HandsetSnapshot snapshot) {
        String before = spoken();
        boolean sameLook = snapshot.screen().equals(phone.screen())
                && snapshot.call().equals(phone.call())
                && snapshot.typed().equals(phone.typed())
                && snapshot.station().equals(phone.station())
                && snapshot.inbox() == phone.inbox()
                && snapshot.outbox() == phone.outbox()
                && snapshot.broadcasts() == phone.broadcasts();
        phone = snapshot;
        if (!sameLook) {
            String after = spoken();
            if (accessibleContext != null && !before.equals(after)) {
                accessibleContext.firePropertyChange(AccessibleContext.ACCESSIBLE_NAME_PROPERTY, before, after);
            }
            repaint();
        }
    }

    /** Paints anew when the minute has changed. */
    void lookAtClock() {
        if (LocalTime.now(clock).getMinute() != shownMinute) {
            repaint();
        }
    }

    /** What the display says, as a sentence. */
    String spoken() {
        if (!phone.station().powered()) {
            return texts.of("lcd.off");
        }
        if (phone.screen() instanceof Screen.Writing writing) {
            return texts.of("menu.write") + ": " + writing.text();
        }
        var call = phone.call();
        if (call.phase() == CallPhase.NONE) {
            return phone.typed().isEmpty() ? texts.of("lcd.own") + " " + phone.own() : phone.typed();
        }
        String words = texts.of("lcd.call." + call.phase().name().toLowerCase(Locale.ROOT)) + " " + call.number();
        return words
                + call.tone()
                        .flatMap(ToneMeaning::textKey)
                        .map(key -> ", " + texts.of(key))
                        .orElse("");
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Drawing.on(graphics);
        try {
            LocalTime now = LocalTime.now(clock);
            shownMinute = now.getMinute();
            painter.paint(g, phone, now, getWidth(), getHeight());
        } finally {
            g.dispose();
        }
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
                @Override
                public AccessibleRole getAccessibleRole() {
                    return AccessibleRole.LABEL;
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
