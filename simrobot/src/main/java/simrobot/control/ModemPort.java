package simrobot.control;

/** Requests of a robot's control to its modem; callable on any thread. */
interface ModemPort {
    /**
     * Sends a tone.
     *
     * @param call number of the call in which it is sent; it is dropped if that call has ended
     * @param key of the telephone
     */
    void sendTone(long call, char key);

    /** Clears this call, and no later one, after the tones requested so far have been sent. */
    void clearCall(long call);

    /** @return false if {@code to} is not a valid number for a short message */
    boolean sendMessage(String to, String text);

    /** While an order is being executed, the modem's idle timer is paused. */
    void setOrderUnderWay(boolean underWay);
}
