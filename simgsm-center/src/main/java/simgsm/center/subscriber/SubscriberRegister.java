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
import simgsm.air.MobileIdentity;
import simgsm.air.Msisdn;
import simgsm.air.Tmsi;

/**
 * The VLR: all known subscribers. In an open network a subscriber is known from the first registration; in a closed
 * one, exactly the subscribers of the {@link HomeRegister} are known.
 */
public final class SubscriberRegister {
    /** Limits the memory for invented SIMs; about 300 octets each. */
    public static final int MAX_SUBSCRIBERS = 200_000;

    /** All ones: no TMSI (TS 23.003, 2.4). */
    private static final int NO_TMSI = -1;

    private final HomeRegister home;
    private final RandomGenerator random;
    private final Consumer<Subscriber> newcomers;
    private final Map<Msisdn, Subscriber> byNumber = new LinkedHashMap<>();
    private final Map<Tmsi, Subscriber> byTmsi = new HashMap<>();
    private int attachedCount;

    /** @param newcomers receives each subscriber who attaches for the first time */
    public SubscriberRegister(HomeRegister home, RandomGenerator random, Consumer<Subscriber> newcomers) {
        this.home = home;
        this.random = random;
        this.newcomers = newcomers;
        home.cards().forEach(card -> byNumber.put(card.number(), new Subscriber(card.number(), card.imsi())));
    }

    public HomeRegister home() {
        return home;
    }

    /**
     * Enters a subscriber who was attached before the centre's start, if the number is still assigned to the IMSI.
     *
     * @param services in the format of {@link CallServices#text}
     */
    public void restore(Msisdn number, Imsi imsi, String services) {
        if (home.numberOf(imsi).equals(Optional.of(number))) {
            Subscriber subscriber = byNumber.computeIfAbsent(number, each -> new Subscriber(each, imsi));
            subscriber.enter();
            subscriber.services().restore(services);
        }
    }

    /** True if messages to this number are accepted: in an open network, any number. */
    public boolean isServed(Msisdn number) {
        return home.isOpen() || isAssigned(number);
    }

    /** True if the number belongs to a subscriber who is not barred. */
    public boolean isAssigned(Msisdn number) {
        Subscriber owner = byNumber.get(number);
        return owner != null && !home.isBarred(owner.imsi());
    }

    /** True if the number is that of a SIM of a closed network, or has registered in an open one. */
    public boolean isSubscriber(Msisdn number) {
        Subscriber owner = byNumber.get(number);
        return owner != null && (!home.isOpen() || owner.hasEntered());
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

    /** The entered subscriber of an IMSI or TMSI. */
    public Optional<Subscriber> ofIdentity(MobileIdentity identity) {
        return identity instanceof Tmsi tmsi
                ? ofTmsi(tmsi)
                : identity instanceof Imsi imsi ? home.numberOf(imsi).flatMap(this::ofNumber) : Optional.empty();
    }

    /** The subscriber of an IMSI, entered if new; empty if the network has none, or the register is full. */
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

    /** Allocates a TMSI; the previous one remains valid until the new one is confirmed (TS 24.008, 4.3.1.5). */
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

    /** The mobile has confirmed its new TMSI. */
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
