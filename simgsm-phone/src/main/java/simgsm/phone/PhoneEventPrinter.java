package simgsm.phone;

import java.util.Map;
import java.util.function.Consumer;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.console.TextBundle;
import simgsm.phone.handset.HandsetEvent;
import simgsm.phone.handset.ToneMeaning;
import simgsm.station.context.StationEvent;
import simgsm.station.context.UssdEnding;

/** Prints the events of the handset and its station on the console. */
record PhoneEventPrinter(Console console, TextBundle texts) implements Consumer<StationEvent> {
    @Override
    public void accept(StationEvent event) {
        if (event instanceof HandsetEvent.ToneHeard heard) {
            String meaning =
                    ToneMeaning.textKey(heard.key()).map(key -> texts.of(key)).orElse("");
            console.emit(Event.from(heard, Map.of("meaning", meaning)));
        } else if (event instanceof StationEvent.HoldRefused) {
            console.error("hold: the network refuses");
        } else if (event instanceof HandsetEvent.KeysNotSent refused) {
            console.error("press: the network refuses the keys " + refused.keys() + ", cause "
                    + refused.cause().code() + ", " + refused.cause().title());
        } else if (!(event instanceof StationEvent.UssdEnded end && end.how() == UssdEnding.COMPLETED)) {
            console.tell(event);
        }
    }
}
