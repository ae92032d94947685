package simgsm.phone.handset;

import java.util.List;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.CallPhase;
import simgsm.phone.screen.HomeKeys;
import simgsm.phone.screen.KeyIntent;
import simgsm.phone.screen.PhoneKey;
import simgsm.phone.screen.Screen.Note;
import simgsm.phone.screen.ScreenNavigation;
import simgsm.sim.PinLock;
import simgsm.ss.ServiceCode;

/**
 * The keys of the window and of a keyboard: selects each key's action by the screen and the call, and performs it on
 * the handset.
 */
public final class HandsetKeys {
    private final Handset handset;
    private final PhoneCall call;
    private final HandsetAudio audio;
    private final ScreenNavigation screens;
    private final HomeKeys home;

    public HandsetKeys(Handset handset) {
        this.handset = handset;
        call = handset.call();
        audio = handset.audio();
        screens = handset.screens();
        home = handset.home();
    }

    /** Presses a key; it sounds until {@link #keyUp}. */
    public void keyDown(PhoneKey key, long nowNanos) {
        handset.timePassed(nowNanos);
        home.hold(key, nowNanos);
        if (!handset.isPowered()) {
            if (key == PhoneKey.END) {
                handset.powerOn();
            }
            return;
        }
        if (key == PhoneKey.END && endsCall()) {
            screens.home();
            handset.hangUp();
        } else if (key == PhoneKey.CALL && call.phase() == CallPhase.RINGING) {
            handset.answer();
        } else {
            askForPin();
            press(key, nowNanos);
        }
        handset.changed();
    }

    private void press(PhoneKey key, long nowNanos) {
        if (screens.isHome()) {
            endTones();
            perform(home.press(key, handset.situation()));
        } else {
            perform(screens.press(key, nowNanos));
        }
        performCode();
    }

    /** Performs a code of the equipment or of the SIM with its last sign (TS 22.030, 6.6.3 and 6.7.2). */
    private void performCode() {
        String typed = screens.isHome() ? home.typed() : screens.typedForCard();
        if (typed.equals(ServiceCode.IMEI) || PinLock.isCode(typed)) {
            handset.codes().send(typed);
        }
    }

    /** After an emergency call the first key returns to the question of a locked SIM, and belongs to it. */
    private void askForPin() {
        PinLock.Status card = handset.station().snapshot().card();
        if (!card.isReady() && screens.isHome() && call.phase() == CallPhase.NONE) {
            endTones();
            screens.askForPin(card);
        }
    }

    /** The red key ends the current call; a held one once the user has read the end of the call before it. */
    private boolean endsCall() {
        CallSnapshot now = call.snapshot();
        boolean endsHeld = now.held().isPresent() && now.ended().isEmpty() && screens.isHome();
        return now.phase() != CallPhase.NONE || endsHeld;
    }

    /** Ends the tones of a released call, at the next key on the home screen. */
    private void endTones() {
        if (call.phase() == CallPhase.NONE) {
            call.clearCause();
            audio.stopTones();
            if (audio.networkPlaysTones()) {
                handset.station().hangUp();
            }
        }
    }

    private void perform(KeyIntent intent) {
        if (intent instanceof KeyIntent.PlayTone play) {
            play(play.tone());
        } else if (intent instanceof KeyIntent.DialText dial) {
            dial(dial.text());
        } else if (intent instanceof KeyIntent.SendText text) {
            send(text);
        } else if (intent instanceof KeyIntent.SendUssd code) {
            handset.codes().send(code.text()).ifPresent(refusal -> screens.note(Note.Kind.REFUSED, code.text()));
        } else if (intent instanceof KeyIntent.UseCard use) {
            handset.codes().useCard(use.command());
        } else if (intent instanceof KeyIntent.ChangeSettings change) {
            handset.set(change.settings());
        } else {
            perform((KeyIntent.Simple) intent);
        }
    }

    private void perform(KeyIntent.Simple intent) {
        switch (intent) {
            case NOTHING -> {}
            case ANSWER -> handset.answer();
            case HANG_UP -> handset.hangUp();
            case SILENCE -> silence();
            case HOLD -> handset.hold().ifPresent(refusal -> screens.note(Note.Kind.REFUSED, ""));
            case REJECT_SECOND -> handset.rejectSecond();
            case END_USSD -> handset.station().endUssd();
            case LOUDER ->
                handset.set(handset.settings().withVolume(handset.settings().volume() + 1));
            case QUIETER ->
                handset.set(handset.settings().withVolume(handset.settings().volume() - 1));
            case SWITCH_OFF -> handset.powerOff();
        }
    }

    private void silence() {
        call.silenced();
        audio.stopTones();
    }

    private void play(DtmfKey tone) {
        boolean isConnected = call.phase() == CallPhase.CONNECTED;
        if (isConnected) {
            handset.keyed(tone);
        }
        int millis = handset.settings().toneLength().millis();
        if (isConnected && millis > 0) {
            audio.press(List.of(tone), millis, () -> {});
        } else {
            audio.keyDown(tone);
        }
    }

    private void dial(String text) {
        try {
            handset.codes()
                    .perform(text)
                    .ifPresent(refusal -> screens.note(
                            refusal == Refusal.SIM_LOCKED ? Note.Kind.SIM_LOCKED : Note.Kind.REFUSED, text));
        } catch (IllegalArgumentException notANumber) {
            screens.note(Note.Kind.NOT_A_NUMBER, text);
        }
    }

    private void send(KeyIntent.SendText text) {
        if (handset.sendMessage(text.to(), text.text()).isPresent()) {
            screens.note(Note.Kind.REFUSED, text.to().toString());
        } else {
            screens.submitted(text);
        }
    }

    /** Releases the key. */
    public void keyUp(PhoneKey key, long nowNanos) {
        handset.timePassed(nowNanos);
        audio.keyUp();
        home.release(key);
        handset.changed();
    }

    /** A keyboard's Enter: the green key on the home screen and for a ringing call, else OK. */
    public void enterDown(long nowNanos) {
        boolean calls = screens.isHome() || call.phase() == CallPhase.RINGING;
        keyDown(calls ? PhoneKey.CALL : PhoneKey.OK, nowNanos);
    }

    public void enterUp(long nowNanos) {
        keyUp(PhoneKey.OK, nowNanos);
    }

    /** Presses a keyboard's character: a letter during text entry, otherwise the phone key of that name. */
    public void charDown(char character, long nowNanos) {
        if (!handset.isPowered()) {
            return;
        }
        askForPin();
        if (screens.type(character)) {
            performCode();
            handset.changed();
        } else if (character == '+' && screens.isHome() && call.phase() == CallPhase.NONE) {
            home.plus();
            handset.changed();
        } else {
            PhoneKey.ofSymbol(character).ifPresent(key -> keyDown(key, nowNanos));
        }
    }

    public void charUp(char character, long nowNanos) {
        PhoneKey.ofSymbol(character).ifPresent(key -> keyUp(key, nowNanos));
    }

    /** Erases the character before the cursor; without one, shows the previous page. */
    public void eraseDown() {
        if (!handset.isPowered()) {
            return;
        }
        if (screens.isHome()) {
            home.erase();
        } else {
            screens.eraseOrBack();
        }
        handset.changed();
    }
}
