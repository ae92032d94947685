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
 * The visitor register: everybody known here, and where each one stands. In an open network a subscriber once registered
 * stays known; in a closed one all whom the {@link HomeRegister} lists are known from the start, and nobody else ever is.
 */
public final class SubscriberRegister {
    /** A subscriber costs about 300 octets; the bound keeps a flood of invented SIMs from filling the memory. */
    public static final int MAX_SUBSCRIBERS = 200_000;

    /** TS 23.003, 2.4: a TMSI of all ones means "none". */
    private static final int NO_TMSI = -1;

    private final HomeRegister home;
    private final RandomGenerator random;
    private final Consumer<Subscriber> newcomers;
    private final Map<Msisdn, Subscriber> byNumber = new LinkedHashMap<>();
    private final Map<Tmsi, Subscriber> byTmsi = new HashMap<>();
    private int attachedCount;

    /** @param newcomers told of everybody who attaches for the first time ever */
    public SubscriberRegister(HomeRegister home, RandomGenerator random, Consumer<Subscriber> newcomers) {
        this.home = home;
        this.random = random;
        this.newcomers = newcomers;
        home.cards().forEach(card -> byNumber.put(card.number(), new Subscriber(card.number(), card.imsi())));
    }

    public HomeRegister home() {
        return home;
    }

    /** Enters somebody who has attached in an earlier life of the centre, if the network is still his. */
    public void restore(Msisdn number, Imsi imsi) {
        if (home.numberOf(imsi).equals(Optional.of(number))) {
            byNumber.computeIfAbsent(number, each -> new Subscriber(each, imsi)).enter();
        }
    }

    /** Whether messages for this number can ever arrive: in an open network its owner may still come. */
    public boolean isServed(Msisdn number) {
        return home.isOpen() || isAssigned(number);
    }

    /** Whether the number is somebody's, barred ones not counted: their numbers are as good as nobody's. */
    public boolean isAssigned(Msisdn number) {
        Subscriber owner = byNumber.get(number);
        return owner != null && !home.isBarred(owner.imsi());
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
        Optional<Msisdn> number = home.numberOf(imsi);
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
