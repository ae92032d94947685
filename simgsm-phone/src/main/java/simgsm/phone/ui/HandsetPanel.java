package simgsm.phone.ui;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.geom.Rectangle2D;
import java.time.Clock;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import javax.swing.Action;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.screen.PhoneKey;
import simgsm.station.StationSnapshot;
import simgsm.ui.CommandGroup;
import simgsm.ui.ComponentNames;
import simgsm.ui.Drawing;
import simgsm.ui.Lamp;
import simgsm.ui.LinkState;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.scope.ToneScopePanel;
import simgsm.ui.window.Display;
import simgsm.ui.window.MenuButton;

/** The handset: display, keys, and a fold with the tone scope or the events. The drawing scales with the panel. */
public final class HandsetPanel extends JPanel {
    private final HandsetLayout layout = new HandsetLayout();
    private final Locale language;
    private final TextBundle texts;
    private final Lcd lcd;
    private final Lamp link;
    private final ToneScopePanel scope;
    private final EventsPanel events;
    private final HandsetFooter foot;
    private final Map<PhoneKey, PhoneKeyButton> keys = new EnumMap<>(PhoneKey.class);
    private HandsetSnapshot shown;
    private boolean isFoldChosen;

    /**
     * Creates a handset that shows the given snapshot until the first call of {@link #show}.
     *
     * @param clock for the time of day on the display
     */
    public HandsetPanel(
            TextBundle texts, Locale language, Clock clock, HandsetSnapshot first, HandsetControls controls) {
        this.texts = texts;
        this.language = language;
        setLayout(layout);
        ComponentNames.name(this, "handset", texts.of("window.title"));
        lcd = new Lcd(texts, language, clock, first);
        place(lcd, HandsetLayout.LCD);
        place(new MenuButton(language), HandsetLayout.WINDOW_MENU);
        link = Lamp.ofLink(language);
        place(link, HandsetLayout.LINK);
        for (PhoneKey key : PhoneKey.values()) {
            PhoneKeyButton button = new PhoneKeyButton(key, texts, controls);
            keys.put(key, button);
            place(button, HandsetLayout.placeOf(key));
        }
        scope = new ToneScopePanel(language, controls::tryOut);
        place(scope, HandsetLayout.SCOPE);
        events = new EventsPanel(texts, new WordsText(texts, clock.getZone()));
        place(events, HandsetLayout.EVENTS);
        foot = new HandsetFooter(texts, this::toggle);
        place(foot, HandsetLayout.FOOT);
        UserAction goToEvents = new UserAction("events.go", texts.of("events.title"), this::goToEvents)
                .in(CommandGroup.VIEW)
                .onKey(this, KeyEvent.VK_2, InputEvent.ALT_DOWN_MASK);
        foot.setToolTip(HandsetFold.EVENTS, (String) goToEvents.getValue(Action.SHORT_DESCRIPTION));
        Keyboard.install(this, texts, controls);
        open(HandsetFold.NONE);
        setBackground(Theme.color(Ink.SURFACE));
        shown = null;
        show(first);
    }

    private void place(Component child, Rectangle2D place) {
        layout.place(child, place);
        add(child);
    }

    /** Shows a newer snapshot. */
    public void show(HandsetSnapshot snapshot) {
        lcd.show(snapshot);
        scope.show(snapshot.trace());
        events.show(snapshot.log());
        if (shown == null || !snapshot.station().equals(shown.station())) {
            link.show(linkState(snapshot.station()), language);
        }
        if (shown == null || !snapshot.sounding().equals(shown.sounding())) {
            keys.forEach((key, button) ->
                    button.setSounding(key.tone().isPresent() && key.tone().equals(snapshot.sounding())));
        }
        if (shown == null || snapshot.unread() != shown.unread()) {
            String news = snapshot.unread() == 0 ? "" : ", " + texts.of("lcd.unread", snapshot.unread());
            keys.get(PhoneKey.ONE).setUnread(snapshot.unread(), texts.of("key.one") + news);
        }
        if (shown == null || !snapshot.softKeys().equals(shown.softKeys())) {
            keys.get(PhoneKey.SOFT_LEFT).setMeaning(soft(snapshot.softKeys().left()));
            keys.get(PhoneKey.SOFT_RIGHT).setMeaning(soft(snapshot.softKeys().right()));
        }
        if (shown == null || snapshot.audible() != shown.audible()) {
            foot.showSound(snapshot.audible());
        }
        shown = snapshot;
    }

    private String soft(String key) {
        return key.isEmpty() ? "" : texts.of(key);
    }

    /** Updates the display's clock; called about once a second. */
    public void lookAtClock() {
        lcd.lookAtClock();
    }

    private static LinkState linkState(StationSnapshot station) {
        if (!station.powered()) {
            return LinkState.OFF;
        }
        if (station.registered()) {
            return LinkState.UP;
        }
        if (station.isEmergencyOnly()) {
            return LinkState.EMERGENCY_ONLY;
        }
        return station.rejectCause().isPresent() ? LinkState.REFUSED : LinkState.SEARCHING;
    }

    HandsetFold fold() {
        return layout.fold();
    }

    /** Opens or closes the tone scope. */
    public void setScopeOpen(boolean open) {
        setFold(open ? HandsetFold.SCOPE : HandsetFold.NONE);
    }

    /**
     * Opens or closes a fold; the window is resized, so that the keys keep their size as far as the screen allows.
     */
    void setFold(HandsetFold next) {
        double scale = layout.scale(this);
        Rectangle2D before = layout.onPanel(this, layout.whole(this));
        boolean changes = next != fold();
        open(next);
        Window window = SwingUtilities.getWindowAncestor(this);
        if (window != null && changes && getWidth() > 0) {
            int frame = window.getHeight() - getHeight();
            Dimension after = layout.sized(scale, Display.usableArea(window).height - frame);
            Display.resize(
                    window,
                    window.getWidth() + after.width - (int) Math.round(before.getWidth()),
                    window.getHeight() + after.height - (int) Math.round(before.getHeight()));
        }
        revalidate();
        repaint();
    }

    /** Opens a fold in a window that is high enough. */
    void open(HandsetFold next) {
        layout.setFold(next);
        scope.setVisible(next == HandsetFold.SCOPE);
        events.setVisible(next == HandsetFold.EVENTS);
        foot.show(next);
    }

    private void toggle(HandsetFold wanted) {
        isFoldChosen = true;
        setFold(fold() == wanted ? HandsetFold.NONE : wanted);
    }

    /** Opens the events and moves the focus there; with the focus there, closes them and moves it to the phone. */
    private void goToEvents() {
        if (events.hasFocusInside()) {
            setFold(HandsetFold.NONE);
            requestFocusInWindow();
        } else {
            setFold(HandsetFold.EVENTS);
            validate();
            events.focus();
        }
    }

    /** A panel that is high enough for it opens the events, until the user opens or closes a fold. */
    @Override
    public void doLayout() {
        if (!isFoldChosen && fold() == HandsetFold.NONE && layout.hasRoomForEvents(getSize())) {
            open(HandsetFold.EVENTS);
        }
        super.doLayout();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setBackground(Theme.color(Ink.SURFACE));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        Graphics2D g = Drawing.on(graphics);
        try {
            double unit = layout.scale(this);
            body(g, unit);
            brand(g, unit);
            pad(g, unit);
            if (fold() != HandsetFold.NONE) {
                screen(g, unit);
            }
        } finally {
            g.dispose();
        }
    }

    private void body(Graphics2D g, double unit) {
        Rectangle2D whole = layout.whole(this);
        var box = layout.onPanel(this, new Rectangle2D.Double(4, 4, whole.getWidth() - 8, whole.getHeight() - 8));
        var body = Drawing.round(box.getX(), box.getY(), box.getWidth(), box.getHeight(), 30 * unit);
        g.setColor(Theme.color(Ink.BODY));
        g.fill(body);
        g.setColor(Theme.color(Ink.BODY_LINE));
        g.setStroke(Theme.stroke(1.2 * unit / Theme.zoom()));
        g.draw(body);
    }

    private void brand(Graphics2D g, double unit) {
        Rectangle2D box = layout.onPanel(this, HandsetLayout.BRAND);
        g.setColor(Theme.color(Ink.TEXT));
        Drawing.centred(
                g,
                texts.of("window.title"),
                Theme.sans(12.5 * unit / Theme.zoom(), true),
                box.getCenterX(),
                box.getCenterY());
    }

    private void screen(Graphics2D g, double unit) {
        Rectangle2D box = layout.onPanel(this, layout.screen(this));
        var sheet = Drawing.round(box.getX(), box.getY(), box.getWidth(), box.getHeight(), Theme.CARD_RADIUS * unit);
        g.setColor(Theme.color(Ink.CARD));
        g.fill(sheet);
        g.setColor(Theme.color(Ink.BODY_LINE));
        g.setStroke(Theme.stroke(unit / Theme.zoom()));
        g.draw(sheet);
    }

    private void pad(Graphics2D g, double unit) {
        Rectangle2D box = layout.onPanel(this, HandsetLayout.PAD);
        double radius = Theme.KEY_RADIUS * 1.5 * unit;
        g.setColor(Theme.color(Ink.KEY_LINE));
        g.fill(Drawing.round(box.getX(), box.getY(), box.getWidth(), box.getHeight(), radius));
        g.setColor(Theme.color(Ink.KEY_FACE));
        g.fill(Drawing.round(
                box.getX() + 1, box.getY() + 1, box.getWidth() - 2, box.getHeight() - 2 - 2 * unit, radius - 1));
    }
}
