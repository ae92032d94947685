package simgsm.sim;

import simgsm.air.Msisdn;

/** A card in a terminal. @param lock its check of the user */
public record InsertedCard(SimCard card, PinLock lock) {
    public Msisdn number() {
        return card.number();
    }
}
