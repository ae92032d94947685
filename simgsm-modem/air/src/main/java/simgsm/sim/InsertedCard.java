package simgsm.sim;

import simgsm.air.Msisdn;

/** A card in a terminal. @param lock its check of the user */
public record InsertedCard(SimCard card, PinLock lock) {
    /** Gives the card its PIN if it asks for one, except for the last try. */
    public void enter(String pin) {
        PinLock.Status card = lock.status();
        if (card.state() == PinLock.State.PIN && card.pinTries() > 1) {
            lock.verify(pin);
        }
    }

    public Msisdn number() {
        return card.number();
    }
}
