package simgsm.phone;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RpCause;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.console.TextBundle;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.handset.HandsetListener;
import simgsm.phone.handset.ToneMeaning;
import simgsm.sms.DeliveryStatus;

/** Prints what the handset tells, field by field as the console's contract has it. */
final class PhoneEventPrinter implements HandsetListener {
    private final Console console;
    private final TextBundle texts;

    PhoneEventPrinter(Console console, TextBundle texts) {
        this.console = console;
        this.texts = texts;
    }

    @Override
    public void registered(Msisdn number) {
        console.emit(Event.of("registered").with("number", number));
    }

    @Override
    public void unregistered(Optional<RejectCause> cause) {
        Event event = Event.of("unregistered");
        console.emit(cause.isPresent() ? event.with("cause", cause.get().code()) : event);
    }

    @Override
    public void calling(Msisdn number) {
        console.emit(Event.of("calling").with("number", number));
    }

    @Override
    public void alerting() {
        console.emit(Event.of("alerting"));
    }

    @Override
    public void ringing(Optional<Msisdn> from) {
        console.emit(Event.of("ringing").with("from", digits(from)));
    }

    @Override
    public void waiting(Optional<Msisdn> from) {
        console.emit(Event.of("waiting").with("from", digits(from)));
    }

    @Override
    public void waitingOver() {
        console.emit(Event.of("waiting-over"));
    }

    @Override
    public void connected(Optional<Msisdn> peer) {
        console.emit(Event.of("connected").with("number", digits(peer)));
    }

    private static String digits(Optional<Msisdn> number) {
        return number.map(Msisdn::digits).orElse("");
    }

    @Override
    public void sent(String keys) {
        console.emit(Event.of("sent").with("keys", keys));
    }

    @Override
    public void keysRefused(String keys, Cause cause) {
        console.error("press: the network refuses the keys " + keys + ", cause " + cause.code() + ", " + cause.title());
    }

    @Override
    public void toneHeard(DtmfKey key) {
        console.emit(Event.of("tone")
                .with("key", key.symbol())
                .with(
                        "meaning",
                        ToneMeaning.textKey(key).map(name -> texts.of(name)).orElse("")));
    }

    @Override
    public void released(Cause cause) {
        console.emit(Event.of("released").with("cause", cause.code()).with("text", cause.title()));
    }

    @Override
    public void messageSent(Msisdn to, int parts, int id) {
        console.emit(Event.of("sms-sent").with("to", to).with("parts", parts).with("id", id));
    }

    @Override
    public void messageFailed(Msisdn to, RpCause cause) {
        console.emit(Event.of("sms-failed")
                .with("to", to)
                .with("cause", cause.code())
                .with("text", cause.title()));
    }

    @Override
    public void messageDelivered(Msisdn to, int id) {
        console.emit(Event.of("sms-delivered").with("to", to).with("id", id));
    }

    @Override
    public void messageUndelivered(Msisdn to, int id, int status) {
        console.emit(Event.of("sms-undelivered")
                .with("to", to)
                .with("id", id)
                .with("status", status)
                .with("text", DeliveryStatus.title(status)));
    }

    @Override
    public void messageReceived(String from, String text) {
        console.emit(Event.of("sms").with("from", from).with("text", text));
    }

    @Override
    public void broadcastReceived(int channel, int pages, String text) {
        console.emit(Event.of("broadcast")
                .with("channel", channel)
                .with("pages", pages)
                .with("text", text));
    }
}
