package simgsm.gateway.esme;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.gateway.esme.TextDelivery.Part;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.SmppViolation;
import simgsm.timer.BoundedMap;
import simgsm.timer.Timers;

/**
 * Joins the parts of texts, whose deliver_sm are answered together. A deliver_sm that the SMSC repeats meanwhile joins the
 * text under way; one that is repeated after the text has been taken is answered from memory.
 */
final class DeliveredTexts {
    /** Time for all parts; shorter than an SMSC waits for deliver_sm_resp. */
    private static final long PARTS_NANOS = TimeUnit.SECONDS.toNanos(20);

    private final Timers timers;
    private final Consumer<TextDelivery> whole;
    /** By the group of the parts. */
    private final Map<String, TextDelivery> underWay = new HashMap<>();

    private final Map<String, Boolean> taken = new BoundedMap<>();

    /** @param whole receives each complete text, and has it answered by {@link #answer} */
    DeliveredTexts(Timers timers, Consumer<TextDelivery> whole) {
        this.timers = timers;
        this.whole = whole;
    }

    void delivered(ApplicationSession session, int sequence, SmppMessage message) {
        if ((message.esmClass() & SmppMessage.RECEIPT) != 0) {
            session.answer(sequence, SmppStatus.OK);
            return;
        }
        Optional<String> number = message.source().number().map(Msisdn::digits);
        DeliveredText text;
        try {
            text = DeliveredText.of(message);
        } catch (SmppViolation noText) {
            session.answer(sequence, SmppStatus.PERMANENT_APPLICATION_ERROR);
            return;
        }
        if (number.isEmpty()) {
            session.answer(sequence, SmppStatus.PERMANENT_APPLICATION_ERROR);
        } else if (taken.containsKey(text.id())) {
            session.answer(sequence, SmppStatus.OK);
        } else {
            String to = message.destination().number().map(Msisdn::digits).orElse("");
            add(new TextDelivery(number.get(), to), new Part(text, session, sequence));
        }
    }

    private void add(TextDelivery first, Part added) {
        TextDelivery delivery = underWay.computeIfAbsent(added.text.group(), group -> begin(first));
        for (Part part : delivery.parts) {
            if (part.text.id().equals(added.text.id())) {
                part.session = added.session;
                part.sequence = added.sequence;
                return;
            }
        }
        if (delivery.parts.stream().anyMatch(part -> part.text.part() == added.text.part())) {
            // Another text with the same reference, while the first is under way.
            added.answer(SmppStatus.TEMPORARY_APPLICATION_ERROR);
            return;
        }
        delivery.parts.add(added);
        if (delivery.isWhole()) {
            timers.cancel(delivery.limit);
            whole.accept(delivery);
        }
    }

    private TextDelivery begin(TextDelivery delivery) {
        delivery.limit = timers.start(PARTS_NANOS, () -> answer(delivery, SmppStatus.TEMPORARY_APPLICATION_ERROR));
        return delivery;
    }

    void answer(TextDelivery delivery, int status) {
        underWay.remove(delivery.parts.get(0).text.group());
        delivery.parts.forEach(part -> {
            if (status == SmppStatus.OK) {
                taken.put(part.text.id(), true);
            }
            part.answer(status);
        });
    }
}
