package simgsm.center.subscriber;

import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.air.Tmsi;

/**
 * Home and visitor register in one, as befits a network in one box. In an open network any SIM of the test network may
 * come, and its IMSI says its number; a subscriber once registered stays known.
 */
public final class SubscriberRegister {
    /** A subscriber costs about 300 octets; the bound keeps a flood of invented SIMs from filling the memory. */
    public static final int MAX_SUBSCRIBERS = 200_000;

    /** TS 23.003, 2.4: a TMSI of all ones means "none". */
    private static final int NO_TMSI = -1;

    private final RandomGenerator random;
    private final Consumer<Subscriber> newcomers;
    private final Map<Msisdn, Subscriber> byNumber = new LinkedHashMap<>();
    private final Map<Tmsi, Subscriber> byTmsi = new HashMap<>();
    private int attachedCount;

    /** @param newcomers told of everybody who attaches for the first time ever */
    public SubscriberRegister(RandomGenerator random, Consumer<Subscriber> newcomers) {
        this.random = random;
        this.newcomers = newcomers;
    }

    /** Enters somebody who has attached in an earlier life of the centre. */
    public void restore(Msisdn number, Imsi imsi) {
        Subscriber known = new Subscriber(number, imsi);
        known.enter();
        byNumber.put(number, known);
    }

    public Collection<Subscriber> all() {
        return Collections.unmodifiableCollection(byNumber.values());
    }

    public int attachedCount() {
        return attachedCount;
    }

    public Optional<Subscriber> ofNumber(Msisdn number) {
        return Optional.ofNullable(byNumber.get(number));
    }

    public Optional<Subscriber> ofTmsi(Tmsi tmsi) {
        return Optional.ofNullable(byTmsi.get(tmsi));
    }

    /** The subscriber behind an IMSI, entered now if new; empty if this network has none or no room for one. */
    public Optional<Subscriber> admit(Imsi imsi) {
        Optional<Msisdn> number = imsi.openNumber();
        if (number.isEmpty()) {
            return Optional.empty();
        }
        Subscriber known = byNumber.get(number.get());
        if (known == null && byNumber.size() < MAX_SUBSCRIBERS) {
            known = new Subscriber(number.get(), imsi);
            byNumber.put(number.get(), known);
        }
        return Optional.ofNullable(known);
    }

    /** Gives a fresh temporary identity; the one before stays until it is confirmed (TS 24.008, 4.3.1.5). */
    public Tmsi allocateTmsi(Subscriber subscriber) {
        subscriber.formerTmsi().ifPresent(byTmsi::remove);
        Tmsi fresh;
        do {
            fresh = new Tmsi(random.nextInt());
        } while (fresh.value() == NO_TMSI || byTmsi.containsKey(fresh));
        byTmsi.put(fresh, subscriber);
        subscriber.tmsi(fresh);
        return fresh;
    }

    /** The mobile has taken its new temporary identity. */
    public void confirmTmsi(Subscriber subscriber) {
        subscriber.formerTmsi().ifPresent(byTmsi::remove);
        subscriber.forgetFormerTmsi();
    }

    public void attach(Subscriber subscriber, Imei equipment) {
        attachedCount += subscriber.isAttached() ? 0 : 1;
        subscriber.attach(equipment);
        if (subscriber.enter()) {
            newcomers.accept(subscriber);
        }
    }

    public void detach(Subscriber subscriber) {
        attachedCount -= subscriber.isAttached() ? 1 : 0;
        subscriber.detach();
    }
}
