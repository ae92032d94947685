package simgsm.gateway.mail;

import java.time.InstantSource;
import java.util.Map;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.gateway.esme.TextDelivery;
import simgsm.timer.BoundedMap;

/**
 * The newest 10 000 mails that became short messages. Each is sent from a number of its own, so that an answer names its
 * mail by its destination, in whatever order the answers arrive.
 */
final class Correspondences {
    /** Digits behind the service's number: a time in ms, which returns after 10<sup>8</sup> ms (27 h 46 min 40 s). */
    static final int MOST_DIGITS = 8;
    /** The least that a long number of the service leaves. */
    static final int LEAST_DIGITS = 4;

    /**
     * A mail that became a short message.
     *
     * @param number it was sent to
     * @param address of its sender
     * @param id its Message-ID with brackets, may be empty
     */
    record Mail(String number, String address, String id, String subject) {}

    private final String service;
    private final long numbers;
    private final InstantSource clock;
    private final Map<String, Mail> mails = new BoundedMap<>();
    private long lastMillis;

    /** @param service number of the application, of at most {@link MailSettings#MOST_DIGITS} digits */
    Correspondences(String service, InstantSource clock) {
        this.service = service;
        numbers = (long) Math.pow(10, Math.min(MOST_DIGITS, Msisdn.MAX_DIGITS - service.length()));
        this.clock = clock;
    }

    /** Gives a mail its number. The time in it is above that of mails before a restart, whose answers are refused. */
    String add(Mail mail) {
        lastMillis = Math.max(lastMillis + 1, clock.millis());
        String own = service + String.valueOf(numbers + lastMillis % numbers).substring(1);
        mails.put(own, mail);
        return own;
    }

    /** The mail that a text answers: its receiver, also in international form, writes to the mail's number. */
    Optional<Mail> answered(TextDelivery delivery) {
        return Optional.ofNullable(mails.get(delivery.to()))
                .filter(mail -> delivery.number().endsWith(mail.number()));
    }
}
